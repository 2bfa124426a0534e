#version 330 compatibility
layout(triangles_adjacency) in;
layout(line_strip, max_vertices = 4) out;
in vec3 vN[6];
out vec4 vColor;
void main() {
    for (int i = 0; i < 4; i++) {
        int k = 2 * (i % 3);
        vColor = vec4(abs(vN[k]), 1.);
        gl_Position = gl_in[k].gl_Position;
        EmitVertex();
    }
}
