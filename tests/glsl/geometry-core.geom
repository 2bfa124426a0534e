#version 330 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
in vec3 vN[3];
out vec4 vColor;
uniform float uShrink;
void main() {
    vec4 center = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
    for (int i = 0; i < 3; i++) {
        vColor = vec4(abs(vN[i]), 1.);
        gl_Position = mix(gl_in[i].gl_Position, center, .3 * uShrink);
        EmitVertex();
    }
    EndPrimitive();
}
