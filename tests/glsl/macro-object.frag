#version 330 compatibility
#define PI 3.14159265
#define TWO_PI (2. * PI)
#define COLOR vec3(1., .5, .25)
in vec2 vST;
void main() { gl_FragColor = vec4(COLOR * (.5 + .5 * sin(TWO_PI * vST.s * 3.)), 1.); }
