#version 330 compatibility
uniform float uA = .5;
uniform vec3 uColor = vec3(.2, .6, .9), uOther = vec3(1., 1. / 3., .25 * 2.);
uniform int uCount = 3;
uniform bool uOn = true;
uniform mat3 uMat = mat3(1.);
in vec3 vN;
void main() { gl_FragColor = vec4((uOn ? uMat * uColor : uOther) * uA * float(uCount) * abs(vN.z) + .1 * uOther, 1.); }
