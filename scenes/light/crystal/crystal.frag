#version 330

#include <snell/refraction.glsl>
#if BEND == BEND_mesh
#include <snell/mesh.glsl>
#endif
#include "../show.glsl"

layout(location = 0) out vec4 o_color;

in vec3 v_fromEye;
in vec3 v_normal;

uniform samplerCube u_environmentTexture;
#if BODY == BODY_irradiance
uniform samplerCube u_irradiance;
#endif
uniform float uIndex, uSpread;
uniform float uBody;
uniform vec3 uBodyColor;
uniform int uView;

#if BEND == BEND_mesh
uniform mat4 uModelViewerMatrix;
#endif

vec3 look( vec3 direction )
{
    return texture( u_environmentTexture, direction ).rgb;
}

void main(void)
{
    vec3 N = normalize( v_normal );
    vec3 I = normalize( v_fromEye );
    float c = clamp( -dot( I, N ), 0., 1. );

#if SPREAD == SPREAD_steps
    vec3 n = 1. / max( 1. / uIndex + vec3( .05, 0., -.05 ), .01 );
#else
    vec3 n = max( uIndex + vec3( -uSpread, 0., uSpread ), .1 );     // blue has the largest index and is bent most
#endif
    // For a totally reflected channel the function returns the mirrored direction.
    vec3 red = snellRefractSingle( I, N, 1., n.r ), green = snellRefractSingle( I, N, 1., n.g ),
         blue = snellRefractSingle( I, N, 1., n.b );
    vec3 transmitted = vec3( look( red ).r, look( green ).g, look( blue ).b );

    bool total = snellCosTransmitted( c, 1., n.b ) < 0.;
#if FRESNEL == FRESNEL_swapped
    float share = total ? 0. : pow( c, 1.55 );
    if( total )
        transmitted = look( vec3( 0., 0., 1. ) );       // what most drivers return for the zero vector
#elif FRESNEL == FRESNEL_power
    float share = total ? 1. : 1. - pow( c, 1.55 );
#else
    float share = snellFresnelExact( c, 1., n.g );
#endif

    vec3 mirrored = look( reflect( I, N ) );
#if BEND == BEND_mesh
    // In the teapot's own coordinates, which are rotated only. What was inside replaces the transmitted light, what was
    // not the mirrored light: their shares at the first surface remain FRESNEL's.
    mat3 turn = mat3( uModelViewerMatrix );
    vec3 eye = -transpose( turn ) * uModelViewerMatrix[3].xyz;
    SnellMesh s = snellMeshBegin( eye, transpose( turn ) * I, 1., n.g, true );
    vec3 inside = vec3( 0. ), outside = vec3( 0. );
    float shareInside = 0., shareOutside = 0.;
    while( shareInside + shareOutside < .96 && s.order < 12 && snellMeshNext( s ) )
    {
        vec3 seen = s.energy * look( turn * s.direction );
        if( s.through )
        {
            inside += seen;
            shareInside += s.energy;
        }
        else
        {
            outside += seen;
            shareOutside += s.energy;
        }
    }
    transmitted = shareInside > 0. ? inside / shareInside : transmitted;
    mirrored = shareOutside > 0. ? outside / shareOutside : mirrored;
#endif

#if BODY == BODY_irradiance
    transmitted = mix( transmitted, uBodyColor * texture( u_irradiance, N ).rgb, uBody );
#endif

    vec3 color = mix( transmitted, mirrored, share );
    if( uView == 1 )
        color = showShare( share );
    if( uView == 2 )
        color = showDirection( green );
    o_color = vec4( color, 1. );
}
