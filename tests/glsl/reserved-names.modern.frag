#version 330 core
in vec3 vN;
uniform float sample;
out vec4 c;
void main() {
    vec3 p = abs(vN), s = p * .5;
    c = vec4(s + .5 * s.x + .0125, 1.) + .01 * sample;
}
