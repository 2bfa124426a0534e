#version 100
// A sequence is a constant in OpenGL ES 1.00.
precision mediump float;
varying vec3 vN;
const float level = (3.0, .5);
const float raised = .25 + (1.0, .125 * (2.0, 1.0));
void main() {
    float a, b, list[(4, 2)];
    list[1] = 0.0;
    a = 1.0, b = a * 2.0;
    gl_FragColor = vec4(abs(vN) * level + raised * a + .1 * (b - 2.0) + list[1], 1.0);
}
