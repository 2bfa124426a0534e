#version 120
varying const vec3 vShade;
void main() {
    vShade = abs(gl_Normal);
    gl_Position = ftransform();
}
