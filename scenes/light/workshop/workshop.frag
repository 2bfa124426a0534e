#version 330

#include <snell/dispersion.glsl>
#include "things.glsl"
#include "../room.glsl"
#include "../show.glsl"
#include "../tone.glsl"

uniform samplerCube uNear;
uniform int uMaterial;
uniform float uExposure;
uniform int uView;

in vec3 vPosition, vNormal, vFromEye;

out vec4 outColor;

// The room, and near objects before it. NEARBY: infinitely far, or on the shell where the objects circle.
vec3 look( vec3 from, vec3 direction )
{
    vec3 far = room( from, direction );
#if NEARBY == NEARBY_still
    return far;
#else
#if NEARBY == NEARBY_shell
    vec3 toward = from + ( length( from ) < SHELL ? 1. : 0. ) * ( sqrt( max( SHELL * SHELL - dot( from, from ) +
                  dot( from, direction ) * dot( from, direction ), 0. ) ) - dot( from, direction ) ) * direction;
#else
    vec3 toward = direction;
#endif
    vec4 near = texture( uNear, toward );
    return mix( far, 4. * near.rgb * near.rgb, near.a );
#endif
}

float fresnel( float c, float n )
{
#if FRESNEL == FRESNEL_f0
    return snellFresnelF0( 1., n );
#elif FRESNEL == FRESNEL_schlick
    return snellFresnelSchlick( c, 1., n );
#else
    return snellFresnelExact( c, 1., n );
#endif
}

// All light of one index of refraction that reaches the eye; `left` is the share that remains inside.
vec3 glass( vec3 I, vec3 N, float n, out float left )
{
    float share = fresnel( -dot( I, N ), n );
    left = 1. - share;
    vec3 color = share * look( vPosition, reflect( I, N ) );
#if REFRACTION == REFRACTION_none
    color += left * look( vPosition, I );
    left = 0.;
#elif REFRACTION == REFRACTION_single
    color += left * look( vPosition, snellRefractSingle( I, N, 1., n ) );
    left = 0.;
#elif REFRACTION == REFRACTION_both
    vec3 T = snellRefractSingle( I, N, 1., n );
    color += left * look( vPosition - 2. * dot( vPosition, T ) * T, snellRefractSphere( I, N, 1., n ) );
    left = 0.;
#else
    SnellSphere s = snellSphereBegin( I, N, 1., n );
    s.reflectance = share;
    s.inside = left;
    for( int order = 1; order <= ORDERS_VALUE && snellSphereNext( s ); order++ )
        color += s.energy * look( s.normal, s.direction );
    left = s.inside;
#endif
    return color;
}

// The same for all colours.
vec3 glassOfColours( vec3 I, vec3 N, vec2 cauchy, out float left )
{
    vec3 n = snellCauchyRgb( cauchy.x, cauchy.y );
#if DISPERSION == DISPERSION_one
    return glass( I, N, n.g, left );
#elif DISPERSION == DISPERSION_three
    float other;
    return vec3( glass( I, N, n.r, other ).r, glass( I, N, n.g, left ).g, glass( I, N, n.b, other ).b );
#else
    int first = snellBandFirst( WAVELENGTHS_VALUE );
    vec3 sum = vec3( 0. );
    left = 0.;
    for( int i = first; i < first + WAVELENGTHS_VALUE; i++ )
    {
        vec4 band = SNELL_BANDS[i];
        float here;
        sum += band.rgb * glass( I, N, snellCauchy( cauchy.x, cauchy.y, band.w ), here );
        left += here / float( WAVELENGTHS_VALUE );
    }
    return sum;
#endif
}

vec3 metalShare( float c, vec3 eta, vec3 k )
{
    vec3 exact = vec3( snellFresnelConductor( c, 1., eta.r, k.r ), snellFresnelConductor( c, 1., eta.g, k.g ),
                       snellFresnelConductor( c, 1., eta.b, k.b ) );
#if FRESNEL == FRESNEL_exact
    return exact;
#else
    vec3 f0 = vec3( snellFresnelConductor( 1., 1., eta.r, k.r ), snellFresnelConductor( 1., 1., eta.g, k.g ),
                    snellFresnelConductor( 1., 1., eta.b, k.b ) );
#if FRESNEL == FRESNEL_f0
    return f0;
#else
    return f0 + ( 1. - f0 ) * snellPow5( 1. - clamp( c, 0., 1. ) );
#endif
#endif
}

void main()
{
    vec3 N = normalize( vNormal ), I = normalize( vFromEye );
    float c = -dot( I, N ), left = 0.;
    vec2 cauchy = GLASS[clamp( uMaterial, 0, GLASSES - 1 )];
    float green = snellCauchyRgb( cauchy.x, cauchy.y ).g;

    vec3 color, share;
    if( uMaterial < GLASSES )
    {
        share = vec3( fresnel( c, green ) );
        color = glassOfColours( I, N, cauchy, left );
    }
    else
    {
        int metal = clamp( uMaterial - GLASSES, 0, 3 );
        share = metalShare( c, METAL_ETA[metal], METAL_K[metal] );
        color = share * look( vPosition, reflect( I, N ) );
    }

    color = toScreen( exp2( uExposure ) * color );
    if( uView == 1 )
        color = share;
    if( uView == 2 )
        color = showShare( snellCosTransmitted2( clamp( c, 0., 1. ), 1., green ) );
    if( uView == 3 )
        color = showDirection( uMaterial < GLASSES ? snellRefractSphere( I, N, 1., green ) : reflect( I, N ) );
    if( uView == 4 )
        color = showShare( 4. * left );
    outColor = vec4( color, 1. );
}
