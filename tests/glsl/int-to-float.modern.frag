#version 330 core
in vec3 vN;
uniform float uAmount;
out vec4 color;
void main() {
    float a = 1.;
    vec3 c = vec3(1., 0., 0.) + 2. * vN / 4.;
    if (uAmount > 0.) a = max(.5, 0.);
    float p = pow(abs(vN.z), 2.);
    color = vec4(abs(c) * a, 1.) * (1. - p / 3.);
}
