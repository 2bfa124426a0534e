#version 120
void main() { gl_FragColor = vec4(gl_Color.rgb * .5 + .5 * vec3(gl_TexCoord[0].st, 0.), 1.); }
