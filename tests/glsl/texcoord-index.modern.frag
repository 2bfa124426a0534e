#version 330 core
in vec2 vST;
out vec4 c;
void main() { c = vec4(vST * 2.5 / 4., 0., 2.5); }
