#version 120
invariant varying vec2 vA;
centroid varying vec2 vB;
varying mat3 vM;
varying vec2 vPair[2];
void main() { gl_FragColor = vec4(vM * vec3(vA, vB.s), 1.) + .2 * abs(vec4(vPair[0], vPair[1])); }
