#version 120
varying vec3 vMC;
void main() {
    float a = noise1(vMC), b = noise1(vMC.xy), c = noise1(vMC.x);
    vec2 d = noise2(vMC);
    vec3 e = noise3(vec4(vMC, 1.));
    vec4 f = noise4(vMC.x);
    float inside = abs(a) <= 1. && abs(b) <= 1. && abs(c) <= 1. && length(d) < 3. && length(e) < 3. && length(f) < 4. ? 1. : 0.;
    gl_FragColor = vec4(inside, .5, .25, 1.);
}
