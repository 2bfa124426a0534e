#version 330 core
in vec2 vST;
out vec4 c;
void main() { c = vec4(vST.s, .5, .25, 1.); }
