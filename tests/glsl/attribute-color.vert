#version 330 compatibility
out vec4 vColor;
void main() {
    vColor = vec4(gl_Color.bgr, gl_Color.a * .75);
    gl_Position = ftransform();
}
