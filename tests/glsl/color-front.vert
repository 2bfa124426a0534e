#version 120
void main() {
    gl_FrontColor = vec4(gl_Color.rgb * .5, 1.);
    gl_FrontSecondaryColor = vec4(.25 * abs(gl_Normal), 1.);
    gl_Position = ftransform();
}
