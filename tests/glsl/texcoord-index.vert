#version 120
void main() {
    for (int i = 0; i < 4; i++) gl_TexCoord[i] = gl_MultiTexCoord0 * float(i + 1) / 4.;
    gl_Position = ftransform();
}
