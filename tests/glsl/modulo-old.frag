#version 120
varying vec2 vST;
void main() {
    int i = int(vST.s * 8.), j = int(vST.t * 8.);
    float checker = (i + j) % 2 == 0 ? 1. : .25;
    int bits = (i & 3) | (j << 1);
    gl_FragColor = vec4(checker, float(bits) / 16., float(i ^ j) / 8., 1.);
}
