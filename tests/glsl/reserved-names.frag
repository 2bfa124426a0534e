#version 120
varying vec3 vN;
uniform float sample;
float input(float x) { return x * .5; }
float texture2(float x) { return x; }
struct Filter { float common; vec3 buffer; };
void main() {
    vec3 patch = abs(vN), shared = patch * input(1.);
    float smooth = shared.x, flat = .5, precise = 1., subroutine = .25, uint = .5, switch_ = 1.;
    float layout = .5, highp = .25, double = .125, image2D = double;
    Filter f;
    f.common = flat;
    f.buffer = shared;
    gl_FragColor = vec4(f.buffer * precise + f.common * smooth + subroutine * uint * .1, switch_) + .01 * sample * (layout + highp + double + image2D);
}
