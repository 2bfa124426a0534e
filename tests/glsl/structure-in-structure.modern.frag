#version 330 core
in vec3 vN;
out vec4 fColor;
void main() { fColor = vec4(vec3(.9, .7, .5) * abs(vN) / 2. + vec3(.35, .25, .25), 1.); }
