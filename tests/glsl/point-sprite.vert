#version 330 compatibility
out vec4 vColor;
void main() {
    vColor = gl_Color;
    gl_PointSize = 6. + 4. * gl_Vertex.y;
    gl_Position = ftransform();
}
