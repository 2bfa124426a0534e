#version 330 compatibility
out const vec3 vShade;
void main() {
    vShade = abs(gl_Normal);
    gl_Position = ftransform();
}
