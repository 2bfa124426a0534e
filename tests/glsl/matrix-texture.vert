#version 330 compatibility
out vec4 vColor;
void main() {
    vec4 st = gl_TextureMatrix[0] * gl_MultiTexCoord0;
    vec4 inv = gl_TextureMatrixInverse[0] * st;
    vec4 tr = gl_TextureMatrixTranspose[0] * gl_MultiTexCoord0;
    vec4 it = gl_TextureMatrixInverseTranspose[0] * gl_MultiTexCoord0;
    vColor = vec4(fract(st.st), .5 * inv.s + .1 * tr.s + .1 * it.t, 1.);
    gl_Position = ftransform();
}
