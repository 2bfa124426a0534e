#version 330

#include <snell/fresnel.glsl>
#include "../show.glsl"

uniform samplerCube uSurroundings;
uniform float uOpacity, uPower, uIndex;
uniform int uView;

in vec3 vNormal;
in vec3 vFromEye;
in float vRing;

out vec4 outColor;

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    if( vRing > .5 )
    {
        float lit = .35 + .65 * max( dot( N, normalize( vec3( -.5, .6, .6 ) ) ), 0. );
        outColor = vec4( lit * vec3( .95, .55, .12 ), 1. );
        return;
    }

    float facing = -dot( I, N );
#if COSINE == COSINE_clamped
    facing = clamp( abs( facing ), 0., 1. );    // both faces of a thin shell mirror the same
#endif

#if OPACITY == OPACITY_constant
    float opacity = uOpacity;
#elif OPACITY == OPACITY_by_angle
    float opacity = pow( max( 1. - facing, 0. ), uPower );
#else
    // Light is mirrored back and forth between the two faces of the shell: the sum of the series.
    float once = snellFresnelExact( facing, 1., uIndex );
    float opacity = 2. * once / ( 1. + once );
#endif

    vec3 mirrored = texture( uSurroundings, reflect( I, N ) ).rgb;
    // Alpha is the share by which this colour covers earlier draws.
    outColor = uView == 1 ? vec4( showShare( opacity ), 1. ) : vec4( mirrored, opacity );
}
