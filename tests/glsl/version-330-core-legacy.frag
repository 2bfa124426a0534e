#version 330 core
in vec3 vN;
void main() { gl_FragColor = vec4(abs(vN), 1.); }
