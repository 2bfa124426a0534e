#version 330 core
in vec3 vN;
centroid in vec4 vColor;
in vec2 vST;
out vec4 fColor;
void main() { fColor = vec4(abs(vN), 1.) * vColor + vec4(vST, 0., 0.) * .2; }
