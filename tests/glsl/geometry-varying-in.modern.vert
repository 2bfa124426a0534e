#version 330 core
in vec4 aVertex;
in vec3 aNormal;
out vec3 vN;
void main() {
    vN = aNormal;
    gl_Position = aVertex;
}
