#version 330 compatibility
in vec3 vNormal;

void main() { gl_FragColor = vec4(vec3(.2, .5, .9) * (.25 + .75 * abs(normalize(vNormal).z)), 1.); }
