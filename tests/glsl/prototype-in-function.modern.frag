#version 330 core
in vec3 vN;
out vec4 fColor;
void main() { fColor = vec4(mix(vec3(.2, .4, .6), abs(vN), .5 + .5 * vN.y), 1.); }
