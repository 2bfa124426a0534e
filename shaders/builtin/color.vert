// Draws without a program: the current colour, unlit.
uniform float snell_PointSize;

void main() {
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
    gl_PointSize = snell_PointSize;
}
