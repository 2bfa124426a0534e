#version 120
void main() { gl_FragColor = gl_Color + vec4(gl_SecondaryColor.rgb, 0.); }
