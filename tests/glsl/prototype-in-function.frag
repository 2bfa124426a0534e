// Prototypes within functions, which GLSL 1.10 had.
varying vec3 vN;
void main() {
    float weight(vec3 n);
    vec3 mixed(in vec3 n, float amount);
    gl_FragColor = vec4(mixed(vN, weight(vN)), 1.);
}
float weight(vec3 n) { return .5 + .5 * n.y; }
vec3 mixed(in vec3 n, float amount) { return mix(vec3(.2, .4, .6), abs(n), amount); }
