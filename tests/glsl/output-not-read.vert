#version 330 compatibility
out vec3 vN, vUnused;
out float vNoOneWants;
void main() {
    vN = gl_NormalMatrix * gl_Normal;
    vUnused = gl_Vertex.xyz;
    vNoOneWants = 1.;
    gl_Position = ftransform();
}
