#version 330 compatibility
uniform float uRed, uGreen;
const vec3 COLOR = vec3(uRed, uGreen, .5);
const vec3 DARK = COLOR * .5;
in vec3 vN;
void main() { gl_FragColor = vec4(mix(DARK, COLOR, abs(vN.z)), 1.); }
