#version 330 core
in vec4 aVertex;
in vec3 aNormal;
in vec2 aTexCoord0;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 N;
out vec2 vST;
void main() {
    N = normalize(uNormalMatrix * aNormal);
    vST = aTexCoord0;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
