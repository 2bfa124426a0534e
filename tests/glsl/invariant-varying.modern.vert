#version 330 core
uniform mat4 uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
in vec4 aVertex, aColor;
in vec3 aNormal;
in vec2 aTexCoord0;
out vec3 vN;
centroid out vec4 vColor;
out vec2 vST;
void main() {
    vN = normalize(uNormalMatrix * aNormal);
    vColor = aColor;
    vST = aTexCoord0;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
