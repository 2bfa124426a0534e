// A word since GLSL 1.20 only.
varying vec3 vN;
void main() {
    vec3 invariant = abs(vN);
    gl_FragColor = vec4(invariant, 1.);
}
