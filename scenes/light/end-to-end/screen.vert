#version 330 compatibility
// Covers the window for the methods that trace rays; the ray through each pixel runs from vNear to vFar.
#include "traced.glsl"
out vec4 vNear, vFar;

void main() {
    vNear = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, -1., 1.);
    vFar = gl_ModelViewProjectionMatrixInverse * vec4(gl_Vertex.xy, 1., 1.);
    gl_Position = vec4(gl_Vertex.xy, 0., 1.);
#if !TRACED
    gl_Position = vec4(2., 2., 2., 1.);
#endif
}
