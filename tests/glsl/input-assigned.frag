#version 330 compatibility
in vec3 vN;
void main() {
    vN = normalize(vN);
    gl_FragColor = vec4(abs(vN), 1.);
}
