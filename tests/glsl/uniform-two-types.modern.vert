#version 330 core
in vec4 aVertex, aColor;
uniform mat4 uModelViewProjectionMatrix;
uniform float uKind;
out vec4 vColor;
void main() {
    vColor = vec4(aColor.rgb * float(int(uKind)), 1.);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
