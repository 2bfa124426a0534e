#version 330 compatibility
const float PI = 3.14159265, TWO_PI = 2. * PI;
const vec4 WHITE = vec4(1.);
float scale = 2.;
vec3 tint = vec3(.5, .75, 1.) * scale;
in vec2 vST;
void main() {
    scale += .5;
    gl_FragColor = WHITE * vec4(tint * .4, 1.) * (.5 + .5 * sin(TWO_PI * scale * vST.s));
}
