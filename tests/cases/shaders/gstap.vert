#version 330
in vec3 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 vNormal;

void main() {
    vNormal = normalize(uNormalMatrix * aNormal);
    gl_Position = uModelViewProjectionMatrix * vec4(aVertex, 1.);
}
