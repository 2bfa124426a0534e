#version 330 core
in vec2 vST;
out vec4 c;
void main() { c = vec4(vec3(vST.s), 1.); }
