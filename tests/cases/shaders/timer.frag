#version 330 compatibility
uniform float Timer;
in vec3 vST;

void main() { gl_FragColor = vec4(vST.s < Timer ? vec3(1., .8, .2) : vec3(.2, .3, .5), 1.); }
