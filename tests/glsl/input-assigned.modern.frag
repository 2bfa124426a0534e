#version 330 core
in vec3 vN;
out vec4 c;
void main() { c = vec4(abs(normalize(vN)), 1.); }
