#version 120
uniform sampler2D uTexUnit;
varying vec2 vST;
void main() { gl_FragColor = vec4(texture(uTexUnit, vST).rgb, 1.); }
