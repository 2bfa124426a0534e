#version 120
uniform sampler2DShadow uShadow;
varying vec2 vST;
void main() { gl_FragColor = vec4(shadow2D(uShadow, vec3(vST, .5)).rrr, 1.); }
