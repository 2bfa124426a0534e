#version 330 core
in vec4 gColor;
out vec4 c;
void main() { c = gColor; }
