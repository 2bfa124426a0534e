#version 120
void main() {
    gl_FragColor = vec4(gl_TexCoord[0].s, fract(gl_TexCoord[1].t), .5 + .5 * gl_TexCoord[3].s, 1.);
}
