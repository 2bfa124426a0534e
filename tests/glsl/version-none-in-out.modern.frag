#version 330 core
in vec3 N;
in vec2 vST;
uniform sampler2D uTexUnit;
out vec4 c;
void main() { c = vec4(texture(uTexUnit, vST).rgb * abs(N.z), 1.); }
