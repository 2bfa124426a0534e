#version 330 core
in vec4 aVertex;
in vec3 aNormal;
uniform mat4 uModelViewProjectionMatrix;
flat out vec4 vFlat;
void main() {
    vFlat = vec4(.5 + .5 * aNormal, 1.);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
