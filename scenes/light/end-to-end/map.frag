#version 330 compatibility
#include "room.glsl"
in vec3 vPoint;

void main() { gl_FragColor = vec4(MAP_SCALE * roomAlong(vec3(0.), vPoint), 1.); }
