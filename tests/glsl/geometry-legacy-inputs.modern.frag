#version 330 core
in vec4 vColor;
in vec2 vST;
out vec4 c;
void main() { c = vec4(vColor.rgb * .5 + .5 * vec3(vST, 0.), 1.); }
