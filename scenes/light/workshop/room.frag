#version 330

#include "../tone.glsl"

uniform samplerCube uRoom;
uniform float uExposure;

in vec3 vPosition;

out vec4 outColor;

void main()
{
    outColor = vec4( toScreen( exp2( uExposure ) * texture( uRoom, vPosition ).rgb ), 1. );
}
