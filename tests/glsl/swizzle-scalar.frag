#version 330 compatibility
in vec2 vST;
void main() {
    float s = vST.s;
    vec3 c = s.xxx;
    gl_FragColor = vec4(c, 1.);
}
