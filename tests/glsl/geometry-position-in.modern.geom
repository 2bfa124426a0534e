#version 330 core
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform mat4 uProjectionMatrix;
in vec3 vNormal[3];
out float gLightIntensity;
void emit(float s, float t) {
    vec3 p = gl_in[0].gl_Position.xyz;
    vec3 v = p + s * (gl_in[1].gl_Position.xyz - p) + t * (gl_in[2].gl_Position.xyz - p);
    gLightIntensity = abs(dot(normalize(vec3(0., 10., 0.) - v), normalize(vNormal[0])));
    gl_Position = uProjectionMatrix * vec4(v, 1.);
    EmitVertex();
}
void main() {
    emit(0., 0.);
    emit(.9, 0.);
    emit(0., .9);
    EndPrimitive();
}
