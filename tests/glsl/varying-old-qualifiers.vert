#version 120
invariant varying vec2 vA;
centroid varying vec2 vB;
varying mat3 vM;
varying vec2 vPair[2];
void main() {
    vA = gl_MultiTexCoord0.st;
    vB = gl_MultiTexCoord0.ts;
    vM = mat3(.5);
    vPair[0] = gl_Normal.xy;
    vPair[1] = gl_Normal.yz;
    gl_Position = ftransform();
}
