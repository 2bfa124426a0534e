#version 330 compatibility
uniform sampler1D uUnit;
in vec3 vST;

void main() { gl_FragColor = vec4(texture(uUnit, vST.s).rgb, 1.); }
