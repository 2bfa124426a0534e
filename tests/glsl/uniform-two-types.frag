#version 330 compatibility
uniform float uKind;
in vec4 vColor;
void main() { gl_FragColor = vColor * uKind; }
