#version 330 compatibility
// The mesh. Methods that trace the ball do not use it.
#include "traced.glsl"
uniform mat4 uModelViewerMatrix;
out vec3 vPoint, vNormal, vRay;  // in world coordinates; vRay from the eye, not of unit length
out vec3 vMirror;
out float vLight;

const vec3 LIGHT = vec3(0., 0., 4.);

void main() {
    vPoint = gl_Vertex.xyz;
    vNormal = normalize(gl_Normal);
    vRay = vec3(uModelViewerMatrix * gl_Vertex);
    // The Orange Book computes reflection and lighting at the vertices.
    vMirror = reflect(vRay, vNormal);
    vLight = max(dot(normalize(LIGHT - vPoint), vNormal), 0.);
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
#if TRACED
    gl_Position = vec4(2., 2., 2., 1.);
#endif
}
