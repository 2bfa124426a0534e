#version 330 core
in vec2 vST;
out vec4 c;
void main() {
    int i = int(vST.s * 8.), j = int(vST.t * 8.);
    c = vec4((i + j) % 2 == 0 ? 1. : .25, float((i & 3) | (j << 1)) / 16., float(i ^ j) / 8., 1.);
}
