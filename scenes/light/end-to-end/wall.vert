#version 330 compatibility
out vec3 vPoint;

void main() {
    vPoint = gl_Vertex.xyz;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
