#version 330 compatibility
out vec4 vColor;
void main() {
    vColor = gl_Color;
    gl_ClipVertex = gl_ModelViewMatrix * gl_Vertex;
    gl_Position = ftransform();
}
