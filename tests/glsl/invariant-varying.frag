#version 120
invariant varying vec3 vN;
invariant centroid varying vec4 vColor;
varying vec2 vST;
invariant vST;
varying vec4 vNever;
invariant vNever;
void main() { gl_FragColor = vec4(abs(vN), 1.) * vColor + vec4(vST, 0., 0.) * .2 + vNever; }
