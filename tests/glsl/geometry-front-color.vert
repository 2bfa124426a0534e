#version 330 compatibility
void main() {
    gl_FrontColor = gl_Color;
    gl_TexCoord[1] = gl_MultiTexCoord0;
    gl_Position = ftransform();
}
