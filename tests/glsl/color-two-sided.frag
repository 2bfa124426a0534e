#version 120
// draw: two-sided
void main() {
    if (fract(gl_FragCoord.x / 16.) < .5) discard;
    gl_FragColor = gl_Color;
}
