#version 330 compatibility
// draw: four targets
in vec3 vN;
in vec2 vST;
layout(location = 0) out vec4 fColor;
layout(location = 1) out vec4 fNormal;
layout(location = 2) out vec4 fST;
layout(location = 3) out vec4 fPlain;
void main() {
    fColor = vec4(vST, .5, 1.);
    fNormal = vec4(abs(vN), 1.);
    fPlain = vec4(.25, .5, .75, 1.);
    fST = vec4(vST, 0., 1.);
}
