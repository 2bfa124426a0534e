#version 330 compatibility
uniform sampler2D Noise2;
uniform sampler3D Noise3;
uniform float uNoiseAmp, uNoiseFreq;
in vec3 vMC;
in vec2 vST;
void main() {
    vec4 nv = texture(Noise3, uNoiseFreq * vMC);
    float n = nv.r + nv.g + nv.b + nv.a;
    n = (n - 2.) * uNoiseAmp;
    gl_FragColor = vec4(texture(Noise2, vST).rg, .5 + n, 1.);
}
