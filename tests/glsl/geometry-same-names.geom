#version 330 compatibility
layout(triangles) in;
layout(triangle_strip) out;
layout(max_vertices = 6) out;
in vec4 vColor[];
out vec4 gColor;
out vec3 gBary;
vec3 corner(int i) { return vec3(i == 0, i == 1, i == 2); }
void emit(int i) {
    gColor = vColor[i];
    gBary = corner(i);
    gl_Position = gl_in[i].gl_Position;
    gl_PrimitiveID = gl_PrimitiveIDIn;
    EmitVertex();
}
void main() {
    emit(0); emit(1); emit(2);
    EndPrimitive();
}
