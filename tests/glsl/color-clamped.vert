#version 120
void main() {
    gl_FrontColor = vec4(gl_Color.rgb * 3. - 1., 1.);
    gl_Position = ftransform();
}
