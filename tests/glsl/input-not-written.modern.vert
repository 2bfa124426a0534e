#version 330 core
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 vN;
void main() {
    vN = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
