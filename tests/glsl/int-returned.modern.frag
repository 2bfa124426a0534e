#version 330 core
in vec3 vN;
out vec4 c;
void main() { c = vec4(vN.x > 0. ? 1. : 0., vN.y > 0. ? 1. : 0., 1., 1.); }
