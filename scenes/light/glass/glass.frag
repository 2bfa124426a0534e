#version 330 compatibility

#include <snell/refraction.glsl>
#include "../room.glsl"
#include "../show.glsl"

uniform float uIndex, uMix, uWhiteMix;
uniform int uView;

in vec3 vPosition, vNormal, vFromEye;

const float RADIUS = 1.2;

void main()
{
    vec3 rightI = normalize( vFromEye ), rightN = normalize( vNormal );

#if LENGTHS == LENGTHS_any
    vec3 I = vFromEye, N = vNormal;
#else
    vec3 I = rightI, N = rightN;
#endif

    float index = uIndex;
#if RATIO == RATIO_slider
    float eta = uIndex;
    index = 1. / uIndex;        // the index that the ball then has
#else
    float eta = 1. / uIndex;
#endif

    vec3 mirrored = reflect( I, N );
    vec3 inside = refract( I, N, eta );
    bool total = inside == vec3( 0. );
    float k = 1. - eta * eta * ( 1. - dot( N, I ) * dot( N, I ) );

#if MIRROR == MIRROR_constant
    float share = total ? 1. : uMix;
#else
    float share = snellFresnelExact( -dot( rightI, rightN ), 1., index );
#endif

    vec3 fromRoom = room( vPosition, mirrored ), through = fromRoom, out1 = inside;
    if( !total )
    {
#if BEND == BEND_none
        out1 = rightI;
        through = room( vPosition, out1 );
#elif BEND == BEND_single
        through = room( vPosition, inside );
#else
        inside = normalize( inside );
        out1 = 2. * dot( inside, rightI ) * inside - rightI;
        vec3 exit = vPosition - 2. * dot( vPosition, inside ) * inside;
        through = room( exit, out1 );
#if BEND == BEND_bounces
        // Light that is mirrored inside leaves at the next exits, weaker each time.
        SnellSphere s = snellSphereBegin( rightI, rightN, 1., index );
        vec3 sum = vec3( 0. );
        float weight = 0.;
        for( int order = 1; order <= 6 && snellSphereNext( s ); order++ )
        {
            vec3 way = order == 1 ? out1 : s.direction, from = order == 1 ? exit : RADIUS * s.normal;
            sum += s.energy * room( from, way );
            weight += s.energy;
        }
        through = weight > 0. ? sum / weight : through;
#endif
#endif
    }
    through = mix( through, vec3( 1. ), uWhiteMix );

    vec3 color = mix( through, fromRoom, share );
    if( uView == 1 )
        color = showDirection( total ? mirrored : out1 );
    if( uView == 2 )
        color = showShare( k );
    if( uView == 3 )
        color = showShare( share );
    if( uView == 4 )
    {
        vec3 right;
        snellRefract( rightI, rightN, 1., uIndex, right );
        color = showDegrees( degrees( snellAngle( normalize( total ? mirrored : inside ), right ) ) );
    }
    gl_FragColor = vec4( color, 1. );
}
