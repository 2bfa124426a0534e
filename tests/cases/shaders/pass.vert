#version 330 compatibility
out vec3 vsNormal;

void main() {
    vsNormal = gl_NormalMatrix * gl_Normal;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
