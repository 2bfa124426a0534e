#version 330 core
in vec3 vN;
out vec4 c;
void main() { c = vec4(-vN.z > -1. ? .75 : .25, abs(vN.xy), 1.); }
