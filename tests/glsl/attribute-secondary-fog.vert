#version 120
varying vec4 vColor;
void main() {
    vColor = vec4(gl_SecondaryColor.rg, gl_FogCoord, 1.);
    gl_Position = ftransform();
}
