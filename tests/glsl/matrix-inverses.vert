#version 330 compatibility
out vec4 vColor;
void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    vec4 back = gl_ModelViewMatrixInverse * eye;
    vec4 clip = gl_ModelViewProjectionMatrix * gl_Vertex;
    vec4 far = gl_ModelViewProjectionMatrixInverse * clip;
    vec4 persp = gl_ProjectionMatrixInverse * (gl_ProjectionMatrix * eye);
    vColor = vec4(.5 + .2 * (back.xyz + far.xyz) / 2., 1.);
    vColor.b = .5 + .1 * persp.z;
    gl_Position = gl_ProjectionMatrix * eye;
}
