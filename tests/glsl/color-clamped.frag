#version 120
void main() { gl_FragColor = vec4(gl_Color.rgb * .5, 1.); }
