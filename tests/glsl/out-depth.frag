#version 330 compatibility
in vec2 vST;
void main() {
    gl_FragColor = vec4(vST, 0., 1.);
    gl_FragDepth = fract(vST.s * 4.) < .5 ? gl_FragCoord.z : .999;
}
