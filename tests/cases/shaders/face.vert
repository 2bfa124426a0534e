#version 330 compatibility
out vec3 vNormal, vST;

void main() {
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vST = gl_MultiTexCoord0.stp;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
