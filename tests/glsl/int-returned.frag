#version 120
varying vec3 vN;
float sign_of(float x) {
    if (x > 0.) return 1;
    return 0;
}
void main() { gl_FragColor = vec4(sign_of(vN.x), sign_of(vN.y), 1, 1); }
