#version 330 compatibility
void main() { gl_FragColor = vec4(gl_Color.rg, gl_TexCoord[1].s, 1.); }
