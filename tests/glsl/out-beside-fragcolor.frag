#version 330 compatibility
in vec3 vN;
out vec4 fColor;
void main() {
    fColor = vec4(abs(vN), 1.);
    gl_FragColor = vec4(abs(vN), 1.);
}
