#version 330 core
in vec3 vN;
uniform vec3 uLight;
out vec4 c;
void main() { c = vec4(uLight * (.2 + .8 * abs(normalize(vN).z)), 1.); }
