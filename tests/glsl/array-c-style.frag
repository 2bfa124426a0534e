#version 330 compatibility
in vec2 vST;
const float weights[3] = { .25, .5, .25 };
void main() {
    vec3 colors[] = { vec3(1., 0., 0.), vec3(0., 1., 0.), vec3(0., 0., 1.) };
    vec3 sum = vec3(0.);
    for (int i = 0; i < 3; i++) sum += weights[i] * colors[i] * (1. + vST.s * float(i));
    gl_FragColor = vec4(sum, 1.);
}
