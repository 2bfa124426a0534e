#version 120
#extension GL_EXT_geometry_shader4 : enable
// GeometryInput gl_triangles GeometryOutput gl_triangle_strip
void main() {
    for (int i = 0; i < gl_VerticesIn; i++) {
        gl_FrontColor = gl_FrontColorIn[i];
        gl_TexCoord[0] = gl_TexCoordIn[i][0];
        gl_Position = gl_PositionIn[i];
        EmitVertex();
    }
    EndPrimitive();
}
