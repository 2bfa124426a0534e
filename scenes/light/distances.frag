#version 330

in vec3 vPosition;

out vec4 outColor;

void main()
{
    outColor = vec4( vec3( .1 * length( vPosition ) ), 1. );
}
