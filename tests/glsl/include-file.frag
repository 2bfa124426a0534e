#version 330 compatibility
#include "include-file.glsl"
in vec3 vN;
void main() { gl_FragColor = vec4(lit(normalize(vN)), 1.); }
