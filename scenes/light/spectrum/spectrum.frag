#version 330

#include <snell/dispersion.glsl>

uniform samplerCube uTent;
uniform float uRed, uGreen, uBlue, uSpread;
uniform int uView;

in vec3 vPosition;
in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

vec3 bent( vec3 I, vec3 N, float n )
{
#if BEND == BEND_single
    return snellRefractSingle( I, N, 1., n );
#else
    return snellRefractSphere( I, N, 1., n );
#endif
}

void main()
{
    vec3 N = normalize( vNormal ), I = normalize( vFromEye );
    vec3 n = max( uGreen + uSpread * vec3( uRed - uGreen, 0., uBlue - uGreen ), 1. );
#if ORDER == ORDER_as_told
    n = n.bgr;
#endif

#if COLOURS == COLOURS_three
    vec3 split = vec3( texture( uTent, bent( I, N, n.r ) ).r, texture( uTent, bent( I, N, n.g ) ).g,
                       texture( uTent, bent( I, N, n.b ) ).b );
#else
    // Cauchy's a + b / w^2, fitted to red's index and blue's.
    float r2 = .611 * .611, b2 = .464 * .464;
    float b = ( n.b - n.r ) / ( 1. / b2 - 1. / r2 ), a = n.r - b / r2;
    int first = snellBandFirst( WAVELENGTHS_VALUE );
    vec3 split = vec3( 0. );
    for( int i = first; i < first + WAVELENGTHS_VALUE; i++ )
    {
        vec4 band = SNELL_BANDS[i];
        float index = max( snellCauchy( a, b, band.w ), 1. );
        split += band.rgb * texture( uTent, bent( I, N, index ) ).rgb;
    }
#endif

    vec3 mirrored = texture( uTent, reflect( I, N ) ).rgb;
    vec3 color = mix( split, mirrored, snellFresnelExact( -dot( I, N ), 1., n.g ) );
    if( uView == 1 )
        color = .5 + 4. * ( bent( I, N, n.r ) - bent( I, N, n.b ) );
    outColor = vec4( color, 1. );
}
