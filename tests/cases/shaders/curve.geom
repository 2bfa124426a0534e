#version 330 compatibility
layout(lines_adjacency) in;
layout(line_strip, max_vertices = 64) out;
uniform int uNum;

void main() {
    for (int i = 0; i <= uNum; i++) {
        float t = float(i) / float(uNum), u = 1. - t;
        gl_Position = u * u * u * gl_in[0].gl_Position + 3. * t * u * u * gl_in[1].gl_Position +
                      3. * t * t * u * gl_in[2].gl_Position + t * t * t * gl_in[3].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
