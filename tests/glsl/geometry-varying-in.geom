#version 120
#extension GL_EXT_geometry_shader4 : enable
// GeometryInput gl_triangles GeometryOutput gl_line_strip
varying in vec3 vN[3];
varying out vec4 gColor;
uniform float uLength;
void main() {
    for (int i = 0; i < 3; i++) {
        gColor = vec4(abs(vN[i]), 1.);
        gl_Position = gl_ModelViewProjectionMatrix * gl_PositionIn[i];
        EmitVertex();
        gl_Position = gl_ModelViewProjectionMatrix * (gl_PositionIn[i] + vec4(.4 * uLength * vN[i], 0.));
        EmitVertex();
        EndPrimitive();
    }
}
