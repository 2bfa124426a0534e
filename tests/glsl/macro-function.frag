#version 330 compatibility
#define SQR(x) ((x) * (x))
#define MIX3(a, b, t) mix(vec3(a), vec3(b), t)
#define DECLARE(type, name) type name =
in vec2 vST;
void main() {
    DECLARE(float, d) sqrt(SQR(vST.s - .5) + SQR(vST.t - .5));
    gl_FragColor = vec4(MIX3(.2, .9, clamp(2. * d, 0., 1.)), 1.);
}
