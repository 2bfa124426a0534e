#version 330 compatibility
uniform sampler2D uUnit;
in vec3 vST;

void main() { gl_FragColor = vec4(texture(uUnit, vST.st).rgb, 1.); }
