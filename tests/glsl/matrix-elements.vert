#version 330 compatibility
out vec4 vColor;
void main() {
    mat3 turn = mat3(gl_ModelViewMatrix);
    vec3 at = gl_ModelViewMatrix[3].xyz, n = gl_NormalMatrix[0] * gl_Normal.x + gl_NormalMatrix[1] * gl_Normal.y;
    float e = gl_ProjectionMatrix[2][3] * gl_ModelViewProjectionMatrix[1].y;
    int unit = 0;
    vec4 st = gl_TextureMatrix[unit] * gl_MultiTexCoord0 + transpose(gl_TextureMatrix[0])[0];
    vColor = vec4(.5 + .2 * (turn * gl_Normal) + .01 * at + .1 * n, 1.) + .05 * vec4(e, st.st, 0.);
    gl_Position = ftransform();
}
