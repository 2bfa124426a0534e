#version 330 core
layout(triangles) in;
layout(line_strip, max_vertices = 6) out;
in vec3 vN[3];
out vec4 gColor;
uniform float uLength;
uniform mat4 uModelViewProjectionMatrix;
void main() {
    for (int i = 0; i < 3; i++) {
        gColor = vec4(abs(vN[i]), 1.);
        gl_Position = uModelViewProjectionMatrix * gl_in[i].gl_Position;
        EmitVertex();
        gColor = vec4(abs(vN[i]), 1.);
        gl_Position = uModelViewProjectionMatrix * (gl_in[i].gl_Position + vec4(.4 * uLength * vN[i], 0.));
        EmitVertex();
        EndPrimitive();
    }
}
