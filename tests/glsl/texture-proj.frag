#version 120
uniform sampler2D uTexUnit;
varying vec2 vST;
void main() {
    vec4 a = texture2DProj(uTexUnit, vec3(vST, 2.)), b = texture2DProj(uTexUnit, vec4(vST, 0., 3.));
    gl_FragColor = vec4(a.rg, b.b, 1.);
}
