#version 120
varying vec4 gl_TexCoord[2];
void main() {
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_TexCoord[1] = vec4(gl_Normal, 1.);
    gl_Position = ftransform();
}
