#version 120
uniform samplerCube uSky;
varying vec3 vN;
void main() { gl_FragColor = vec4(textureCube(uSky, normalize(vN)).rgb, 1.); }
