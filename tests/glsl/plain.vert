#version 330 compatibility
// The vertex shader of programs that bring none.
out vec3 vMC, vEC, vN;
out vec2 vST;
out vec4 vColor;
void main() {
    vMC = gl_Vertex.xyz;
    vEC = (gl_ModelViewMatrix * gl_Vertex).xyz;
    vN = normalize(gl_NormalMatrix * gl_Normal);
    vST = gl_MultiTexCoord0.st;
    vColor = gl_Color;
    gl_FrontColor = gl_Color;
    gl_TexCoord[0] = gl_MultiTexCoord0;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
