#version 120
uniform sampler3D uVolume;
varying vec3 vMC;
void main() { gl_FragColor = vec4(texture3D(uVolume, vMC).rgb, 1.); }
