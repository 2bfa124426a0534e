#version 330 compatibility
// draw: points
layout(points) in;
layout(points, max_vertices = 2) out;
out vec4 vColor;
void main() {
    vColor = vec4(1., .5, 0., 1.);
    gl_PointSize = 3.;
    gl_Position = gl_in[0].gl_Position;
    EmitVertex();
    vColor = vec4(0., .5, 1., 1.);
    gl_PointSize = 2.;
    gl_Position.xyz = gl_in[0].gl_Position.xyz + vec3(.3, 0., 0.);
    gl_Position.w = gl_in[0].gl_Position.w;
    EmitVertex();
}
