#version 330 compatibility
out vec4 vColor;
void main() {
    vec3 n = gl_NormalMatrix * gl_Normal * gl_NormalScale;
    vColor = vec4(.5 + .4 * n, 1.);
    gl_Position = ftransform();
}
