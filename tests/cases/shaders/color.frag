#version 330 compatibility
in vec4 vColor;

void main() { gl_FragColor = vColor; }
