#version 330 compatibility
centroid in vec2 vA;
noperspective in vec2 vB;
smooth in vec2 vC;
in vec4 vArray[2];
void main() { gl_FragColor = vec4(vA.s, vB.s, abs(vC.x), 1.) * .7 + .2 * vArray[0] + .1 * vArray[1]; }
