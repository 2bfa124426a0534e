#version 330 compatibility
out vec4 vColor;
void main() {
    vec3 n = gl_NormalMatrix * gl_Normal * gl_NormalScale;
    vec3 m = mat3(gl_ModelViewMatrixInverseTranspose) * gl_Normal;
    vColor = vec4(.5 + .5 * normalize(n).xy, .5 + .5 * normalize(m).z, 1.);
    gl_Position = ftransform();
}
