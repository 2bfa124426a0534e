#version 330 core
uniform sampler2D uTexUnit;
in vec2 vST;
out vec4 c;
void main() { c = vec4(texture(uTexUnit, vST).rgb, 1.); }
