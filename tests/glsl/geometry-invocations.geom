#version 400 compatibility
layout(triangles, invocations = 2) in;
layout(triangle_strip, max_vertices = 3) out;
in vec3 vN[];
out vec4 vColor;
void main() {
    for (int i = 0; i < 3; i++) {
        vColor = vec4(abs(vN[i].xy), float(gl_InvocationID), 1.);
        gl_Position = gl_in[i].gl_Position;
        gl_Position.xy = gl_Position.xy * .5 + (float(gl_InvocationID) - .5) * gl_Position.w * vec2(.9, 0.);
        EmitVertex();
    }
    EndPrimitive();
}
