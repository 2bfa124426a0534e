#version 330 core
uniform float uRed, uGreen;
in vec3 vN;
out vec4 c;
void main() {
    vec3 color = vec3(uRed, uGreen, .5);
    c = vec4(mix(color * .5, color, abs(vN.z)), 1.);
}
