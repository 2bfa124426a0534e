#version 120
varying vec4 gl_TexCoord[2];
void main() { gl_FragColor = vec4(gl_TexCoord[0].st, abs(gl_TexCoord[1].z), 1.); }
