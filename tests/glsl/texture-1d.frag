#version 120
uniform sampler1D uRamp;
varying vec2 vST;
void main() { gl_FragColor = vec4(texture1D(uRamp, vST.s).rgb, 1.); }
