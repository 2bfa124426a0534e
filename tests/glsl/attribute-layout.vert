#version 400 compatibility
layout(location = 0) in vec4 aVertex;
layout(location = 1) in vec3 aNormal;
out vec4 vColor;
void main() {
    vColor = vec4(abs(aNormal), 1.);
    gl_Position = gl_ModelViewProjectionMatrix * aVertex;
}
