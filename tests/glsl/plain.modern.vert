#version 330 core
in vec4 aVertex;
in vec3 aNormal;
in vec4 aColor;
in vec4 aTexCoord0;
uniform mat4 uModelViewMatrix, uModelViewProjectionMatrix;
uniform mat3 uNormalMatrix;
out vec3 vMC, vEC, vN;
out vec2 vST;
out vec4 vColor;
void main() {
    vMC = aVertex.xyz;
    vEC = (uModelViewMatrix * aVertex).xyz;
    vN = normalize(uNormalMatrix * aNormal);
    vST = aTexCoord0.st;
    vColor = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
