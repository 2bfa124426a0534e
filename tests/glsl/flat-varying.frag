#version 120
flat varying vec4 vFlat;
void main() { gl_FragColor = vFlat; }
