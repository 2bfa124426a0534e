#version 400 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in vec3 teNormal[];
out vec4 vColor;
void main() {
    vec4 c = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
    for (int i = 0; i < 3; i++) {
        vColor = vec4(abs(teNormal[i]), 1.);
        gl_Position = gl_ProjectionMatrix * (c + .8 * (gl_in[i].gl_Position - c));
        EmitVertex();
    }
}
