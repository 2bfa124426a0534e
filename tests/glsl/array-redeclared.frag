#version 120
// An array gets its size where it is declared again.
varying vec3 vN;
float weights[];
float weights[2];
void main() {
    vec3 [] colors;
    colors[0] = vec3(.2, .4, .6);
    colors[1] = abs(vN);
    vec3 [2] colors;
    weights[0] = .25;
    weights[1] = .5;
    vec3 sum = vec3(0.);
    for (int n = 0; n < 2; ++n) sum += colors[n] * weights[n];
    gl_FragColor = vec4(sum, 1.);
}
