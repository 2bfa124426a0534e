#version 330 compatibility
uniform sampler2D uTexUnit;
in vec2 vST;
vec4 blurred(sampler2D image, vec2 st, float d) {
    return (texture(image, st + vec2(d, 0.)) + texture(image, st - vec2(d, 0.)) + texture(image, st)) / 3.;
}
void main() { gl_FragColor = vec4(blurred(uTexUnit, vST, .01).rgb, 1.); }
