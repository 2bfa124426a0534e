#version 110
varying vec3 vN;
uniform float uAmount;
float half_of(float x) { return x / 2; }
void main() {
    float a = 1;
    vec3 c = vec3(1, 0, 0) + 2 * vN / 4;
    if (uAmount > 0) a = max(half_of(1), 0);
    float p = pow(abs(vN.z), 2);
    gl_FragColor = vec4(abs(c) * a, 1) * (1 - p / 3);
}
