#version 120
vec4 ec = gl_ModelViewMatrix * gl_Vertex;
varying vec4 vColor;
void main() {
    vColor = vec4(.5 + .2 * ec.xy, .5, 1.);
    gl_Position = gl_ProjectionMatrix * ec;
}
