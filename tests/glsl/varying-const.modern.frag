#version 330 core
in vec3 vShade;
out vec4 c;
void main() { c = vec4(vShade, 1.); }
