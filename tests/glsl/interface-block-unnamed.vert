#version 330 compatibility
out Shading {
    vec3 normal;
    float light;
};
void main() {
    normal = gl_NormalMatrix * gl_Normal;
    light = abs(normal.z);
    gl_Position = ftransform();
}
