#version 330 compatibility

#include "../room.glsl"
#include "../show.glsl"

uniform int uView;

in vec3 vNormal, vEyeDir;
in vec3 vPosition, vFromEye, vWorldNormal;

void main()
{
#if NORMAL == NORMAL_interpolated
    vec3 mirrored = reflect( vEyeDir, vNormal );
#else
    vec3 mirrored = reflect( normalize( vEyeDir ), normalize( vNormal ) );
#endif

    vec3 color = room( vPosition, mirrored );
    if( uView == 1 )
        color = showDirection( mirrored );
    if( uView == 2 )
        color = showDegrees( degrees( snellAngle( normalize( mirrored ), snellReflect( vFromEye, vWorldNormal ) ) ) );
    if( uView == 3 )
        color = showShare( 1. - 50. * ( 1. - length( vNormal ) ) );
    gl_FragColor = vec4( color, 1. );
}
