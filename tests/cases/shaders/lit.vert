#version 330 compatibility
out vec3 vNormal, vPosition;
out vec3 vST;
out vec4 vColor;

void main() {
    vNormal = normalize(gl_NormalMatrix * gl_Normal);
    vPosition = (gl_ModelViewMatrix * gl_Vertex).xyz;
    vST = gl_MultiTexCoord0.stp;
    vColor = gl_Color;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
