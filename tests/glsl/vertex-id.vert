#version 330 compatibility
out vec4 vColor;
void main() {
    vColor = vec4(float(gl_VertexID % 16) / 15., float(gl_InstanceID), .5, 1.);
    gl_Position = ftransform();
}
