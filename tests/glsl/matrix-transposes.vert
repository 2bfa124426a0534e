#version 120
varying vec4 vColor;
void main() {
    vec4 a = gl_ModelViewMatrixTranspose * gl_Vertex;
    vec4 b = gl_ProjectionMatrixTranspose * gl_Vertex;
    vec4 c = gl_ModelViewProjectionMatrixTranspose * gl_Vertex;
    vec4 d = gl_ModelViewMatrixInverseTranspose * vec4(gl_Normal, 0.);
    vec4 e = gl_ProjectionMatrixInverseTranspose * gl_Vertex;
    vec4 f = gl_ModelViewProjectionMatrixInverseTranspose * gl_Vertex;
    vColor = vec4(.5 + .05 * (a + b).x, .5 + .05 * (c + d).y, .5 + .01 * (e + f).z, 1.);
    gl_Position = ftransform();
}
