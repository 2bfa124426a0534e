#version 330 compatibility
#include "glass.glsl"
uniform samplerCube uRoom;
in vec3 vPoint, vNormal, vRay;

void main() {
#if METHOD == METHOD_exit_box_120
    gl_FragColor = vec4(glassExact(uRoom, vPoint, vNormal, vRay, true, true), 1.);
#else
    discard;
#endif
}
