#version 330 compatibility
#define RESULT gl_FragColor
#define N vN
#define LOOKUP(t, st) texture2D(t, st)
uniform sampler2D uTexUnit;
in vec3 vN;
in vec2 vST;
void main() { RESULT = vec4(LOOKUP(uTexUnit, vST).rgb * abs(N.z), 1.); }
