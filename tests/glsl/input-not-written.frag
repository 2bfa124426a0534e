#version 330 compatibility
in vec3 vN;
in vec3 vMissing;
void main() { gl_FragColor = vec4(abs(vN) + vMissing, 1.); }
