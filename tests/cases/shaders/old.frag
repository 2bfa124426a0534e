#version 120
varying vec3 vNormal;

void main() { gl_FragColor = vec4(vec3(.9, .5, .2) * (.25 + .75 * abs(normalize(vNormal).z)), 1.); }
