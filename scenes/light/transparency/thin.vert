#version 330

uniform mat4 PVM;
uniform mat4 M;
uniform mat4 uModelViewerMatrix;

in vec4 position;
in vec4 normal;
in vec4 aColor;

out vec3 vNormal;
out vec3 vFromEye;
out float vRing;

// True if the ladders select this draw; see the scene.
bool wanted()
{
    if( aColor.r > .5 )
        return true;
    bool after = aColor.g > .5;
    int side = int( aColor.b + .5 );
#if ORDER == ORDER_glass_first
    if( after )
        return false;
#else
    if( !after )
        return false;
#endif
#if SIDES == SIDES_both
    return side == 0;
#elif SIDES == SIDES_front
    return side == 2;
#else
    return side != 0;
#endif
}

// Everything is in world space, as the cube map needs.
void main()
{
    vNormal = vec3( M * normal );
    vFromEye = vec3( uModelViewerMatrix * position );
    vRing = aColor.r;
    gl_Position = wanted() ? PVM * position : vec4( 2., 2., 2., 1. );
}
