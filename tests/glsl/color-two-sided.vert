#version 120
void main() {
    gl_FrontColor = vec4(.9, gl_Color.g, .1, 1.);
    gl_BackColor = vec4(.1, .2, gl_Color.b, 1.);
    gl_Position = ftransform();
}
