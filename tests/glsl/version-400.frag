#version 400 compatibility
in vec3 vN;
void main() {
    float a = fma(vN.z, .5, .5);
    gl_FragColor = vec4(a, abs(vN.xy), 1.);
}
