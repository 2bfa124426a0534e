// Draws without a program: the current colour, unlit.
uniform mat4 snell_ModelViewProjectionMatrix;
in vec4 snell_Vertex;
in vec4 snell_Color;
out vec4 color;

void main() {
    color = snell_Color;
    gl_Position = snell_ModelViewProjectionMatrix * snell_Vertex;
    gl_PointSize = 1.0;
}
