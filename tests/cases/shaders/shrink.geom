#version 330 compatibility
layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;
uniform float uShrink;
in vec3 vsNormal[3];
out vec3 vNormal;

void main() {
    vec4 center = (gl_in[0].gl_Position + gl_in[1].gl_Position + gl_in[2].gl_Position) / 3.;
    for (int i = 0; i < 3; i++) {
        vNormal = vsNormal[i];
        gl_Position = mix(center, gl_in[i].gl_Position, uShrink);
        EmitVertex();
    }
    EndPrimitive();
}
