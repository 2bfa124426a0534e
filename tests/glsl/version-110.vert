#version 110
attribute vec3 Tangent;
varying vec3 vN;
void main() {
    vN = gl_NormalMatrix * gl_Normal + 0.1 * Tangent;
    gl_Position = ftransform();
}
