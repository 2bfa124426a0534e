#version 130
in vec3 Tangent;
out vec3 vN;
flat out int vKind;
void main() {
    vN = gl_NormalMatrix * gl_Normal + .1 * Tangent;
    vKind = gl_Vertex.y > 0. ? 1 : 0;
    gl_Position = ftransform();
}
