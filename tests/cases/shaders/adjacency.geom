#version 330 compatibility
layout(triangles_adjacency) in;
layout(line_strip, max_vertices = 6) out;

vec3 face(int a, int b, int c) {
    return cross(gl_in[b].gl_Position.xyz - gl_in[a].gl_Position.xyz, gl_in[c].gl_Position.xyz - gl_in[a].gl_Position.xyz);
}

// The edges where a front face meets a back face: the silhouette.
void edge(int a, int b, int outside) {
    if (face(0, 2, 4).z > 0. && face(b, a, outside).z <= 0.) {
        gl_Position = gl_ProjectionMatrix * gl_in[a].gl_Position;
        EmitVertex();
        gl_Position = gl_ProjectionMatrix * gl_in[b].gl_Position;
        EmitVertex();
        EndPrimitive();
    }
}

void main() {
    edge(0, 2, 1);
    edge(2, 4, 3);
    edge(4, 0, 5);
}
