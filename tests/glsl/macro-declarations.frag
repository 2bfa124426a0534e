#version 330 compatibility
#define VARYING in
#define UNIFORM(type, name) uniform type name
#define TEXTURE(s, st) texture2D(s, st)
#ifndef M_PI
const float M_PI = 3.14159265;
#endif
VARYING vec2 vST;
UNIFORM(sampler2D, uTexUnit);
UNIFORM(float, uGain) = .75;
void main() { gl_FragColor = TEXTURE(uTexUnit, vST) * uGain * (.5 + .5 * cos(M_PI * vST.s)); }
