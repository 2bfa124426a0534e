#version 330 compatibility
#define ORDERS 24
#define GRID 16
#include "sphere.glsl"
