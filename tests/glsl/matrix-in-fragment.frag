#version 330 compatibility
in vec3 vN;
void main() {
    vec4 world = gl_ModelViewMatrixInverse * vec4(vN, 0.);
    gl_FragColor = vec4(abs(gl_NormalMatrix * world.xyz), 1.);
}
