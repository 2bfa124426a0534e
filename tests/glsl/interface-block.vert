#version 330 compatibility
out Shared {
    vec3 normal;
    vec2 st;
} vOut;
void main() {
    vOut.normal = gl_NormalMatrix * gl_Normal;
    vOut.st = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
