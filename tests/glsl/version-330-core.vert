#version 330 core
layout(location = 0) in vec4 aVertex;
layout(location = 1) in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 n;
void main() {
    n = uNormalMatrix * aNormal;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
