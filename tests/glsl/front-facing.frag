#version 330 compatibility
in vec2 vST;
void main() {
    if (fract(vST.s * 6.) > .5) discard;
    gl_FragColor = gl_FrontFacing ? vec4(1., .5, 0., 1.) : vec4(0., .5, 1., 1.);
}
