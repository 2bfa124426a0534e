#version 330

#include <snell/fresnel.glsl>
#include <snell/environment.glsl>
#include "../materials.glsl"

#if ROUGH == ROUGH_mirror
uniform samplerCube uRoom;
#else
uniform samplerCube uBlurred;
uniform float uRoughness;
#endif
uniform int uView;

in vec3 vPosition, vNormal, vFromEye;
flat in int vMetal;

out vec4 outColor;

vec3 exact( float c, vec3 eta, vec3 k )
{
    return vec3( snellFresnelConductor( c, 1., eta.r, k.r ), snellFresnelConductor( c, 1., eta.g, k.g ),
                 snellFresnelConductor( c, 1., eta.b, k.b ) );
}

void main()
{
    vec3 N = normalize( vNormal ), I = normalize( vFromEye );
    float c = -dot( I, N );
    vec3 eta = METAL_ETA[vMetal], k = METAL_K[vMetal];
    vec3 right = exact( c, eta, k ), f0 = exact( 1., eta, k );

#if FRESNEL == FRESNEL_f0
    vec3 share = f0;
#elif FRESNEL == FRESNEL_schlick
    vec3 share = vec3( snellFresnelSchlick5( c, f0.r ), snellFresnelSchlick5( c, f0.g ),
                       snellFresnelSchlick5( c, f0.b ) );
#else
    vec3 share = right;
#endif

    vec3 look = snellBoxDirection( vPosition, reflect( I, N ), vec3( 5. ), vec3( 0. ) );
#if ROUGH == ROUGH_mirror
    vec3 mirrored = texture( uRoom, look ).rgb;
#else
    // The last level, for roughness 1, has 8 texels a side.
    float last = log2( float( textureSize( uBlurred, 0 ).x ) / 8. );
    vec3 mirrored = textureLod( uBlurred, look, uRoughness * last ).rgb;
#endif

    vec3 color = share * mirrored;
    if( uView == 1 )
        color = share;
    if( uView == 2 )
        color = .5 + 8. * ( share - right );
    outColor = vec4( color, 1. );
}
