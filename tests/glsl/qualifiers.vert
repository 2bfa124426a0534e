#version 330 compatibility
invariant gl_Position;
centroid out vec2 vA;
noperspective out vec2 vB;
smooth out vec2 vC;
out vec4 vArray[2];
void main() {
    vA = gl_MultiTexCoord0.st;
    vB = gl_MultiTexCoord0.ts;
    vC = gl_Normal.xy;
    vArray[0] = gl_Color;
    vArray[1] = gl_Vertex;
    gl_Position = ftransform();
}
