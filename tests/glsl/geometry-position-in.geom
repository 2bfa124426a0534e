#version 330 compatibility
#extension GL_EXT_gpu_shader4: enable
#extension GL_EXT_geometry_shader4: enable
layout(triangles) in;
layout(triangle_strip, max_vertices = 204) out;
uniform int uLevel;
in vec3 vNormal[3];
out float gLightIntensity;
const vec3 LIGHTPOS = vec3(0., 10., 0.);
vec3 V0, V01, V02;
void ProduceVertex(float s, float t) {
    vec3 v = V0 + s * V01 + t * V02;
    vec3 n = normalize(vNormal[0]);
    gLightIntensity = abs(dot(normalize(LIGHTPOS - v), n));
    gl_Position = gl_ProjectionMatrix * vec4(v, 1.);
    EmitVertex();
}
void main() {
    V01 = (gl_PositionIn[1] - gl_PositionIn[0]).xyz;
    V02 = (gl_PositionIn[2] - gl_PositionIn[0]).xyz;
    V0 = gl_PositionIn[0].xyz;
    ProduceVertex(0., 0.);
    ProduceVertex(.9, 0.);
    ProduceVertex(0., .9);
    EndPrimitive();
}
