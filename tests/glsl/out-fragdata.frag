#version 120
// draw: four targets
varying vec3 vN;
void main() {
    gl_FragData[0] = vec4(abs(vN), 1.);
    gl_FragData[1] = vec4(abs(vN.zyx), 1.);
    gl_FragData[2] = vec4(.5 + .5 * vN, .5);
    gl_FragData[3] = vec4(.25, .5, .75, 1.);
}
