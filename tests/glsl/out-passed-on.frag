#version 330 compatibility
in vec3 vN;
void darken(inout vec4 c, float by) { c.rgb *= by; }
vec4 start() { return vec4(abs(vN), 1.); }
void main(void) {
    gl_FragColor = start();
    darken(gl_FragColor, .8);
    if (vN.x > 0.) return;
    darken(gl_FragColor, .5);
}
