#version 330

#include <snell/refraction.glsl>
#include "../show.glsl"

uniform samplerCube uSurroundings;
uniform float uOutside, uInside;
uniform int uView;

in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

// The mirrored share; c is the cosine of the angle of incidence.
float mirroredShare( float c, float k )
{
    float f0 = snellFresnelF0( uOutside, uInside );
#if FRESNEL == FRESNEL_plus_cos
    return f0 + ( 1. - f0 ) * ( 1. + c ) * ( 1. + c );
#elif FRESNEL == FRESNEL_unused
    return f0;
#elif FRESNEL == FRESNEL_k
    return 1. - clamp( k, 0., 1. );
#elif FRESNEL == FRESNEL_one_minus_cos
    return snellFresnelOneMinusCos( c );
#elif FRESNEL == FRESNEL_power2
    return snellFresnelSchlick2( c, f0 );
#elif FRESNEL == FRESNEL_cg
    return snellFresnelCg( c, .3, 2., 2. );
#elif FRESNEL == FRESNEL_cg_fitted
    return snellFresnelCg( c, .048, .848, 4.55 );
#elif FRESNEL == FRESNEL_schlick
    return snellFresnelSchlick( c, uOutside, uInside );
#elif FRESNEL == FRESNEL_gaussian
    return snellFresnelGaussian( c, uOutside, uInside );
#else
    return snellFresnelExact( c, uOutside, uInside );
#endif
}

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    float c = clamp( -dot( I, N ), 0., 1. );
    float k = snellCosTransmitted2( c, uOutside, uInside );     // below 0: no light is transmitted
    float share = mirroredShare( c, k );

    // If no light is transmitted, the functions return the mirrored direction.
#if BEND == BEND_single
    vec3 bent = snellRefractSingle( I, N, uOutside, uInside );
#else
    vec3 bent = snellRefractSphere( I, N, uOutside, uInside );
#endif
    vec3 mirrored = texture( uSurroundings, reflect( I, N ) ).rgb;
    vec3 transmitted = texture( uSurroundings, bent ).rgb;

    vec3 color = mix( transmitted, mirrored, share );
    if( uView == 1 )
        color = showShare( share );
    if( uView == 2 )
        color = vec3( 4. * abs( share - snellFresnelExact( c, uOutside, uInside ) ) );
    if( uView == 3 )
        color = showShare( k );
    if( uView == 4 )
        color = showDirection( bent );
    outColor = vec4( color, 1. );
}
