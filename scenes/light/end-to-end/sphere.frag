#version 330 compatibility
#if METHOD == METHOD_sphere_map_2
#define THROUGH_MAP
#define ORDERS 2
#define GRID 1
#elif METHOD == METHOD_sphere_5
#define ORDERS 5
#define GRID 1
#elif METHOD == METHOD_sphere_5_2x2
#define ORDERS 5
#define GRID 2
#elif METHOD == METHOD_sphere_8_4x4
#define ORDERS 8
#define GRID 4
#elif METHOD == METHOD_reference
#define ORDERS 24
#define GRID 16
#else
#define ORDERS 2
#define GRID 1
#endif
#include "sphere.glsl"
