#version 330 compatibility
uniform sampler2D uTexUnit;
in vec2 vST;
void main() { gl_FragColor = mix(texture(uTexUnit, vST), texture2D(uTexUnit, 2. * vST), .5); }
