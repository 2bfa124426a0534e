#version 120
uniform sampler2D uTexUnit;
uniform samplerCube uSky;
varying vec2 vST;
varying vec3 vN;
void main() { gl_FragColor = vec4(texture2D(uTexUnit, vST, 1.).rg, textureCube(uSky, vN, .5).b, 1.); }
