#version 110
varying vec3 vN;
void main() { gl_FragColor = vec4(0.5 + 0.5 * normalize(vN), 1.0); }
