#version 330 compatibility
in vec3 vN;
out vec4 fFragColor;
void main() { fFragColor = vec4(abs(vN), .5); }
