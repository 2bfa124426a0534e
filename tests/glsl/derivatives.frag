#version 120
varying vec2 vST;
void main() {
    vec2 w = fwidth(vST) * 20.;
    gl_FragColor = vec4(abs(dFdx(vST.s)) * 30., abs(dFdy(vST.t)) * 30., w.x, 1.);
}
