#version 330 compatibility
out vec4 vColor;

void main() {
    vec4 eye = gl_ModelViewMatrix * gl_Vertex;
    vColor = vec4(.5 + .5 * gl_Vertex.xyz, 1.);
    gl_PointSize = 24. / -eye.z;
    gl_Position = gl_ProjectionMatrix * eye;
}
