#version 330 compatibility

#include "../show.glsl"

uniform samplerCube uWorld;
uniform float uTurn, uSun;
uniform int uView;

in vec3 vLook, vNormal;

void main()
{
    float c = cos( radians( uTurn ) ), s = sin( radians( uTurn ) );
    vec3 look = vec3( c * vLook.x - s * vLook.z, vLook.y, s * vLook.x + c * vLook.z );

    vec3 toSun = normalize( vec3( sin( radians( uSun ) ), .35, cos( radians( uSun ) ) ) );
    float lit = .06 + .94 * max( dot( normalize( vNormal ), toSun ), 0. );

    // Without normalize(): a cube map ignores the length.
    vec3 color = lit * texture( uWorld, look ).rgb;
    gl_FragColor = vec4( uView == 1 ? showDirection( look ) : color, 1. );
}
