#version 330 compatibility
layout(points) in;
layout(triangle_strip, max_vertices = 4) out;
in vec3 vN[];
out vec4 vColor;
uniform float uSize;
void main() {
    vec4 p = gl_ModelViewMatrix * gl_in[0].gl_Position;
    for (int i = 0; i < 4; i++) {
        vec2 corner = vec2(i % 2, i / 2) - .5;
        vColor = vec4(abs(vN[0]), 1.);
        gl_Position = gl_ProjectionMatrix * (p + vec4(.2 * uSize * corner, 0., 0.));
        EmitVertex();
    }
    EndPrimitive();
}
