#version 330 core
in vec3 vN;
out vec4 fColor;
void main() { fColor = vec4(vec3(.2, .4, .6) * .25 + abs(vN) * .5, 1.); }
