#version 330 compatibility
uniform float uStripes, uWidth;
uniform vec3 uDark, uLight;
uniform bool uAcross;
in vec3 vST;

void main() {
    float at = fract((uAcross ? vST.t : vST.s) * uStripes);
    gl_FragColor = vec4(mix(uDark, uLight, step(at, uWidth)), 1.);
}
