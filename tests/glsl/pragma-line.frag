#version 330 compatibility
#pragma optimize(on)
#line 100
in vec3 vN;
#line 7
void main() { gl_FragColor = vec4(abs(vN), float(__LINE__) / 7.); }
