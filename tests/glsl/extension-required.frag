#version 120
#extension GL_EXT_geometry_shader4 : require
varying vec3 vN;
void main() { gl_FragColor = vec4(abs(vN), 1.); }
