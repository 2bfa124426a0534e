#version 330 core
uniform float uKind;
in vec4 vColor;
out vec4 c;
void main() { c = vColor * uKind; }
