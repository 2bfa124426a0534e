#version 120
void main() {
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_TexCoord[1] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
    gl_TexCoord[3].st = gl_Normal.xy;
    gl_TexCoord[3].pq = vec2(0., 1.);
    gl_Position = ftransform();
}
