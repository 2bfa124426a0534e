#version 330 compatibility
in Shading {
    vec3 normal;
    float light;
};
void main() { gl_FragColor = vec4(abs(normal) * light, 1.); }
