#version 330 core
in vec4 aVertex;
uniform mat4 uModelViewMatrix, uProjectionMatrix;
out vec4 vColor;
void main() {
    vec4 ec = uModelViewMatrix * aVertex;
    vColor = vec4(.5 + .2 * ec.xy, .5, 1.);
    gl_Position = uProjectionMatrix * ec;
}
