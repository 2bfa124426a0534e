#version 120
varying vec4 vColor;
void main() {
    vec3 n = gl_NormalMatrix * gl_Normal;
    vColor = vec4(.5 + .5 * n, 1.);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
