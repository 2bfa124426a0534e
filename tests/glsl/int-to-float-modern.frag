#version 330 compatibility
in vec3 vN;
void main() {
    float a = 1, b = 3 / 2;
    vec3 c = clamp(2 * vN, 0, 1);
    c = mix(c, vec3(1), 0.5);
    gl_FragColor = vec4(c * a / 2, b / 2);
}
