out vec3 N;
out vec2 vST;
void main() {
    N = normalize(gl_NormalMatrix * gl_Normal);
    vST = gl_MultiTexCoord0.st;
    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;
}
