#version 110
varying vec2 vST;
void main() { gl_FragColor = vec4(vST.s * 1.0f, .5f, 0.25F, 1.f); }
