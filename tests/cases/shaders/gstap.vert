#version 330
out vec3 vNormal;

void main() {
    vNormal = normalize(uNormalMatrix * aNormal);
    gl_Position = uModelViewProjectionMatrix * aVertex;
}
