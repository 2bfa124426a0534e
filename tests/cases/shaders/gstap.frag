#version 330
in vec3 vNormal;
out vec4 fColor;

void main() { fColor = vec4(.5 + .5 * normalize(vNormal), 1.); }
