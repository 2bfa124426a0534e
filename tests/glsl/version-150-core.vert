#version 150
in vec4 aVertex;
in vec4 aColor;
uniform mat4 uModelViewProjectionMatrix;
out vec4 color;
void main() {
    color = aColor;
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
