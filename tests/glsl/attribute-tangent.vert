#version 120
attribute vec3 Tangent;
varying vec4 vColor;
void main() {
    vec3 t = normalize(Tangent), b = cross(gl_Normal, t);
    vColor = vec4(.5 + .5 * b, 1.);
    gl_Position = ftransform();
}
