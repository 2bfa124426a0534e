#version 430 compatibility
layout(location = 3) out vec3 vNormal;
layout(location = 5) out vec2 vCoord;
void main() {
    vNormal = gl_NormalMatrix * gl_Normal;
    vCoord = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
