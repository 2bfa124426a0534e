#version 330 compatibility
// draw: points
in vec4 vColor;
void main() { gl_FragColor = vec4(gl_PointCoord, vColor.b, 1.); }
