#version 330 compatibility
// The fragment shader of programs that bring none.
in vec4 vColor;
void main() { gl_FragColor = vColor; }
