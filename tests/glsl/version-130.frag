#version 130
in vec3 vN;
flat in int vKind;
out vec4 fColor;
void main() { fColor = vKind == 1 ? vec4(abs(vN), 1.) : vec4(.5, abs(vN.xy), 1.); }
