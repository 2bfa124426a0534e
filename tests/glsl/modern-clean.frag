#version 330 core
in vec2 vST;
uniform sampler2D uTexUnit;
out vec4 fColor;
void main() { fColor = texture(uTexUnit, vST); }
