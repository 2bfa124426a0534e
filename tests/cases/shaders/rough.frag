#version 330 compatibility
#include <snell/environment.glsl>
uniform samplerCube uRoom;
uniform float uRoughness;
in vec3 vNormal, vPosition;

void main() {
    vec3 r = mat3(gl_ModelViewMatrixInverse) * reflect(normalize(vPosition), normalize(vNormal));
    gl_FragColor = vec4(snellPrefiltered(uRoom, r, uRoughness), 1.);
}
