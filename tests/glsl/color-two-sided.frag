#version 120
// TwoSided
void main() {
    if (fract(gl_TexCoord[0].s + gl_FragCoord.x / 64.) < .5) discard;
    gl_FragColor = gl_Color;
}
