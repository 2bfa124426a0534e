#version 330 core
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewMatrix;
uniform mat3 uNormalMatrix;
out vec3 vNormal;
void main() {
    vNormal = normalize(uNormalMatrix * aNormal);
    gl_Position = uModelViewMatrix * aVertex;
}
