#version 330

#include <snell/dispersion.glsl>
#include "../room.glsl"
#include "../show.glsl"

uniform float uIndex;       // for yellow light, 587.6 nm
uniform float uAbbe;
uniform int uView;

in vec3 vPosition;
in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

// Cauchy's n = a + b / w^2, w in micrometres, by Abbe's number (n yellow - 1) / (n blue - n red) at three lines of the
// spectrum.
vec2 cauchy()
{
    const float yellow = .58756, blue = .48613, red = .65627;
    float b = ( uIndex - 1. ) / uAbbe / ( 1. / ( blue * blue ) - 1. / ( red * red ) );
    return vec2( uIndex - b / ( yellow * yellow ), b );
}

// The direction in which light of one index leaves, and the colour seen there.
vec3 leaves( vec3 I, vec3 N, float n )
{
#if BEND == BEND_single
    return snellRefractSingle( I, N, 1., n );
#else
    return snellRefractSphere( I, N, 1., n );
#endif
}
vec3 through( vec3 I, vec3 N, float n )
{
#if BEND == BEND_single
    return room( vPosition, leaves( I, N, n ) );
#else
    vec3 T = snellRefractSingle( I, N, 1., n );
    return room( vPosition - 2. * dot( vPosition, T ) * T, leaves( I, N, n ) );
#endif
}

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    vec2 ab = cauchy();
    vec3 n = snellCauchyRgb( ab.x, ab.y );      // blue has the largest index: it is bent most
#if COLOURS == COLOURS_steps
    n = 1. / ( 1. / uIndex + vec3( 0., .01, .02 ) );
#elif COLOURS == COLOURS_one
    n = vec3( uIndex );
#endif

#if COLOURS != COLOURS_bands
    vec3 split = vec3( through( I, N, n.r ).r, through( I, N, n.g ).g, through( I, N, n.b ).b );
#else
    int first = snellBandFirst( WAVELENGTHS_VALUE );
    vec3 split = vec3( 0. );
    for( int i = first; i < first + WAVELENGTHS_VALUE; i++ )
    {
        vec4 band = SNELL_BANDS[i];
        split += band.rgb * through( I, N, snellCauchy( ab.x, ab.y, band.w ) );
    }
#endif

    float c = -dot( I, N );
#if FRESNEL == FRESNEL_cg
    float share = snellFresnelCg( c, .3, 2., 2. );
#else
    float share = snellFresnelExact( c, 1., uIndex );
#endif

    vec3 color = mix( split, room( vPosition, reflect( I, N ) ), share );
    if( uView == 1 )
        color = .5 + 4. * ( leaves( I, N, n.r ) - leaves( I, N, n.b ) );
    if( uView == 2 )
        color = showShare( share );
    outColor = vec4( color, 1. );
}
