#version 120
#extension GL_EXT_geometry_shader4 : enable
uniform float uShrink;
varying in vec3 vsNormal[3];
varying out vec3 vNormal;

void main() {
    vec4 center = (gl_PositionIn[0] + gl_PositionIn[1] + gl_PositionIn[2]) / 3.;
    for (int i = 0; i < gl_VerticesIn; i++) {
        vNormal = vsNormal[i];
        gl_Position = mix(center, gl_PositionIn[i], uShrink);
        EmitVertex();
    }
    EndPrimitive();
}
