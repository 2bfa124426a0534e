#version 330 core
flat in vec4 vFlat;
out vec4 c;
void main() { c = vFlat; }
