#version 330 compatibility
uniform int uKind;
out vec4 vColor;
void main() {
    vColor = vec4(gl_Color.rgb * float(uKind), 1.);
    gl_Position = ftransform();
}
