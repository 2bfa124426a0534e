#version 330 compatibility
uniform sampler3D uUnit;
in vec3 vST;

void main() { gl_FragColor = vec4(texture(uUnit, vST).rgb, 1.); }
