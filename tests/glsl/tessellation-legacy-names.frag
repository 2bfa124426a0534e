#version 400 compatibility
void main() { gl_FragColor = gl_Color; }
