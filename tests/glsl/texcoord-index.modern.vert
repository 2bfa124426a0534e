#version 330 core
in vec4 aVertex;
in vec2 aTexCoord0;
uniform mat4 uModelViewProjectionMatrix;
out vec2 vST;
void main() {
    vST = aTexCoord0;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
