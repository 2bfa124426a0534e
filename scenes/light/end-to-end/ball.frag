#version 330 compatibility
#include "glass.glsl"
uniform samplerCube uRoom;
in vec3 vPoint, vNormal, vRay, vMirror;
in float vLight;

void main() {
    vec3 color = vec3(0.);
#if METHOD == METHOD_o_mirror
    const vec3 BASE = vec3(.4, .4, 1.);
    color = mix(mapInfinite(uRoom, vMirror), vLight * BASE, .2);
#elif METHOD == METHOD_d_offsets
    color = glassOffsets(uRoom, vNormal, vRay);
#elif METHOD == METHOD_b_defaults
    color = glassMixed(uRoom, vNormal, vRay, 1.1, 0.);
#elif METHOD == METHOD_r_schlick2
    color = glassSchlick2(uRoom, vNormal, vRay);
#elif METHOD == METHOD_b_eta
    color = glassMixed(uRoom, vNormal, vRay, 1. / 1.5, .1);
#elif METHOD == METHOD_single
    color = glassExact(uRoom, vPoint, vNormal, vRay, false, false);
#elif METHOD == METHOD_single_box
    color = glassExact(uRoom, vPoint, vNormal, vRay, false, true);
#elif METHOD == METHOD_exit
    color = glassExact(uRoom, vPoint, vNormal, vRay, true, false);
#elif METHOD == METHOD_exit_box
    color = glassExact(uRoom, vPoint, vNormal, vRay, true, true);
#endif
    gl_FragColor = vec4(color, 1.);
}
