#version 120
varying vec3 vsNormal;

void main() {
    vsNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = ftransform();
}
