#version 330 core
in vec4 aVertex, aColor;
in vec2 aTexCoord0;
uniform mat4 uModelViewProjectionMatrix;
out vec4 vColor;
out vec2 vST;
void main() {
    vColor = aColor;
    vST = aTexCoord0;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
