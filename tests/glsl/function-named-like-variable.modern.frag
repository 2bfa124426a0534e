#version 330 core
in vec3 vN;
out vec4 fColor;
void main() { fColor = vec4(abs(vN) * .5 + .25, 1.); }
