#version 120
varying vec4 gColor;
void main() { gl_FragColor = gColor; }
