#version 330 core
in vec3 n;
layout(location = 0) out vec4 color;
void main() { color = vec4(abs(normalize(n)), 1.); }
