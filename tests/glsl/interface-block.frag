#version 330 compatibility
in Shared {
    vec3 normal;
    vec2 st;
} vIn;
void main() { gl_FragColor = vec4(abs(vIn.normal.z), vIn.st, 1.); }
