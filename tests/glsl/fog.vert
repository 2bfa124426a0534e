#version 120
void main() {
    gl_FogFragCoord = -(gl_ModelViewMatrix * gl_Vertex).z / 10.;
    gl_FrontColor = gl_Color;
    gl_Position = ftransform();
}
