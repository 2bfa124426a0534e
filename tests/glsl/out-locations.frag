#version 330 compatibility
// FourTargets
in vec3 vN;
in vec2 vST;
layout(location = 0) out vec4 fColor;
layout(location = 1) out vec4 fNormal;
layout(location = 2) out vec2 fST;
void main() {
    fColor = vec4(vST, .5, 1.);
    fNormal = vec4(abs(vN), 1.);
    fST = vST;
}
