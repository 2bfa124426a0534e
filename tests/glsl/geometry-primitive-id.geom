#version 330 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
out vec4 vColor;
void main() {
    for (int i = 0; i < gl_in.length(); i++) {
        vColor = vec4(float(gl_PrimitiveIDIn % 8) / 8., .5, 1., 1.);
        gl_Position = gl_in[i].gl_Position;
        EmitVertex();
    }
}
