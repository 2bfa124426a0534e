#version 430 compatibility
layout(location = 3) in vec3 vNormal;
layout(location = 5) in vec2 vCoord;
void main() { gl_FragColor = vec4(abs(vNormal).xy, vCoord.s, 1.); }
