#version 330 compatibility
in vec2 vST;
uniform float uDensity = .5;
void main() {
    if (fract(vST.s * 10.) > uDensity) discard;
    gl_FragColor = vec4(vST, 1., 1.);
}
