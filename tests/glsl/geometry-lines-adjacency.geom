#version 330 compatibility
layout(lines_adjacency) in;
layout(line_strip, max_vertices = 20) out;
in vec4 vColor[];
out vec4 gColor;
uniform int uNum;
void main() {
    float dt = 1. / float(4 + uNum);
    for (int i = 0; i <= 4 + uNum; i++) {
        float t = float(i) * dt, u = 1. - t;
        gColor = vColor[0];
        gl_Position = u * u * u * gl_in[0].gl_Position + 3. * u * u * t * gl_in[1].gl_Position +
                      3. * u * t * t * gl_in[2].gl_Position + t * t * t * gl_in[3].gl_Position;
        EmitVertex();
    }
    EndPrimitive();
}
