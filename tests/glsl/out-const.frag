#version 330 compatibility
in vec3 vShade;
void main() { gl_FragColor = vec4(vShade, 1.); }
