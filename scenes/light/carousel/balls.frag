#version 330

#include "orbit.glsl"

in vec3 vNormal;
flat in int vBall;

out vec4 outColor;

void main()
{
    outColor = vec4( lit( paint( vBall ), normalize( vNormal ) ), 1. );
}
