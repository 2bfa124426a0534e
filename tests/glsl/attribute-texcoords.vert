#version 330 compatibility
out vec4 vColor;
void main() {
    vec4 sum = gl_MultiTexCoord0 + gl_MultiTexCoord1 + gl_MultiTexCoord2 + gl_MultiTexCoord3 + gl_MultiTexCoord4 +
               gl_MultiTexCoord5 + gl_MultiTexCoord6 + gl_MultiTexCoord7;
    vColor = vec4(sum.stp / 8., 1.);
    gl_Position = ftransform();
}
