#version 120
uniform sampler2D texture;
varying vec2 vST;
void main() { gl_FragColor = vec4(texture2D(texture, vST).rgb, 1.); }
