#version 330 compatibility
#if __VERSION__ >= 130
in vec3 vN;
#else
varying vec3 vN;
#endif
#ifdef GL_compatibility_profile
#define OUT gl_FragColor
#else
out vec4 fColor;
#define OUT fColor
#endif
void main() { OUT = vec4(abs(vN), 1.); }
