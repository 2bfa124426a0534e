#version 330 compatibility
uniform float uA, uB = .5, uC;
uniform vec3 uTint = vec3(.9), uOther;
in vec3 vN;
void main() { gl_FragColor = vec4(abs(vN) * uTint * (uA + uB) * .6 + .1 * uOther * uC, 1.); }
