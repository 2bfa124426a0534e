#version 330 core
in vec2 vST;
out vec4 c;
void main() { c = vec4(.25, .5 * (1. + vST.s), .25 * (1. + 2. * vST.s), 1.); }
