#version 330 compatibility
in vec3 vN;
void main() {
    vec4 c = vec4(abs(vN), 1.);
    gl_FragData[0] = c;
    gl_FragData[0].r *= .5;
}
