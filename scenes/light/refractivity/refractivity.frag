#version 330

#include <snell/refraction.glsl>
#include "../room.glsl"
#include "../show.glsl"

layout(location = 0) out vec4 o_color;

in vec3 v_position, v_normal, v_fromEye, v_inside;
in vec2 v_st;

uniform sampler2D uMap;
uniform float uIndex;
uniform vec3 uFrost;
uniform int uView;

void main(void)
{
    vec3 N = normalize( v_normal ), I = normalize( v_fromEye );
#if WHERE == WHERE_vertex
    vec3 inside = snellNormalize( v_inside, -N );
#else
    vec3 inside = snellRefractSingle( I, N, 1., uIndex );
#endif

#if BEND == BEND_single
    vec3 bent = inside;
    vec3 seen = room( v_position, bent );
#else
    vec3 bent = 2. * dot( inside, I ) * inside - I;     // holds for a ball around the origin
    vec3 seen = room( v_position - 2. * dot( v_position, inside ) * inside, bent );
#endif

    float c = clamp( -dot( I, N ), 0., 1. );
#if FRESNEL == FRESNEL_none
    float share = 0.;
#elif FRESNEL == FRESNEL_away
    float share = 1. - c;
#elif FRESNEL == FRESNEL_power
    float share = 1. - pow( c, 1.55 );
#else
    float share = snellFresnelExact( c, 1., uIndex );
#endif

    float clear = 1.;
#if MAP == MAP_on
    clear = texture( uMap, v_st ).r;
#endif
    float lit = .45 + .55 * max( dot( N, normalize( vec3( .2, .75, .6 ) ) ), 0. );
    vec3 below = mix( lit * uFrost, seen, clear );

    vec3 color = mix( below, room( v_position, reflect( I, N ) ), share );
    if( uView == 1 )
        color = showDirection( bent );
    if( uView == 2 )
        color = showShare( share );
    if( uView == 3 )
        color = showShare( clear );
    o_color = vec4( color, 1. );
}
