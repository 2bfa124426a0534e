#version 120
varying vec4 vColor;
void main() {
    vec4 ec = gl_ModelViewMatrix * gl_Vertex;
    float s = dot(gl_Vertex, gl_ObjectPlaneS[0]), t = dot(ec, gl_EyePlaneT[0]);
    vColor = vec4(.5 + .2 * s, .5 + .2 * t, dot(ec, gl_EyePlaneR[1]) + gl_TextureEnvColor[0].b, 1.);
    gl_Position = ftransform();
}
