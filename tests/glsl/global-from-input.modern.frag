#version 330 core
in vec3 vN;
uniform float uGain;
out vec4 c;
void main() {
    float light = abs(normalize(vN).z) * uGain;
    c = vec4(vec3(.5, .2, .3) * light + light * .5, 1.);
}
