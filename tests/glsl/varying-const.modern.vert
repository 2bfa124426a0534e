#version 330 core
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
out vec3 vShade;
void main() {
    vShade = abs(aNormal);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
