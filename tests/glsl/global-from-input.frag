#version 120
varying vec3 vN;
uniform float uGain;
vec3 normal = normalize(vN);
float light = abs(normal.z) * uGain, half_light = light * .5;
vec3 shade(vec3 c) { return c * light + half_light; }
void main() { gl_FragColor = vec4(shade(vec3(.5, .2, .3)), 1.); }
