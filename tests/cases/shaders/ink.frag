#version 330 compatibility
uniform vec3 uInk;

void main() { gl_FragColor = vec4(uInk, 1.); }
