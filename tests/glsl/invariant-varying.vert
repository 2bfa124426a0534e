#version 120
invariant varying vec3 vN;
invariant centroid varying vec4 vColor;
varying vec2 vST;
invariant vST;
invariant gl_Position;
void main() {
    vN = normalize(gl_NormalMatrix * gl_Normal);
    vColor = gl_Color;
    vST = gl_MultiTexCoord0.st;
    gl_Position = ftransform();
}
