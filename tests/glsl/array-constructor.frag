#version 120
varying vec2 vST;
void main() {
    vec3 colors[3] = vec3[3](vec3(1., 0., 0.), vec3(0., 1., 0.), vec3(0., 0., 1.));
    float w[2];
    w[0] = vST.s;
    w[1] = 1. - vST.s;
    vec3 sum = vec3(0.);
    for (int i = 0; i < colors.length(); i++) sum += colors[i] * w[i == 0 ? 0 : 1];
    gl_FragColor = vec4(sum, 1.);
}
