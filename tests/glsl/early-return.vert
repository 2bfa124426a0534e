#version 330 compatibility
out vec4 vColor;
vec3 vEye;
void main(void) {
    gl_Position = ftransform();
    gl_FrontColor = gl_Color;
    vEye = (gl_ModelViewMatrix * gl_Vertex).xyz;
    vColor = vec4(1., .5, .25, 1.);
    if (gl_Vertex.x > 0.) return;
    vColor = vec4(.25, .5 + .1 * vEye.y, 1., 1.);
}
