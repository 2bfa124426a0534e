#version 120
uniform sampler2D uTexUnit;
uniform float uScale;
void main() { gl_FragColor = vec4(texture2D(uTexUnit, gl_TexCoord[0].st * uScale).rgb, 1.); }
