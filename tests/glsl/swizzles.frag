#version 120
varying vec3 vN;
void main() {
    vec4 v = vec4(vN, 1.).zyxw;
    v.rg = v.gr;
    v.stp.x = .5;
    float s = v.xyz.zyx.y;
    vec2 one = vec2(s).yx;
    gl_FragColor = abs(vec4(v.stp, 1.)) * .8 + one.x * .1;
}
