#version 330

#include "things.glsl"
#include "../tone.glsl"

uniform samplerCube uRoom, uIrradiance;
uniform bool uScreen;       // otherwise for the cube map: sqrt(light / 4), so that 8 bits represent up to 4
uniform float uExposure;

in vec3 vPosition, vNormal, vFromEye;
flat in int vThing;

out vec4 outColor;

vec3 light()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );     // from the ball for the cube map, and from the eye for the screen
    vec3 look = snellBoxDirection( vPosition, reflect( I, N ), vec3( HALF_ROOM ), vec3( 0. ) );
    float c = clamp( -dot( I, N ), 0., 1. );
    if( vThing == SATELLITE )
    {
        vec3 share = vec3( snellFresnelConductor( c, 1., METAL_ETA[0].r, METAL_K[0].r ),
                           snellFresnelConductor( c, 1., METAL_ETA[0].g, METAL_K[0].g ),
                           snellFresnelConductor( c, 1., METAL_ETA[0].b, METAL_K[0].b ) );
        return share * texture( uRoom, look ).rgb;
    }
    // Polished slate: a little mirrored light, and the diffuse light that the surface collects.
    float veins = .5 + .5 * sin( 9. * vPosition.y + 2. * sin( 5. * vPosition.x + 3. * vPosition.z ) );
    vec3 slate = mix( vec3( .16, .20, .22 ), vec3( .34, .38, .38 ), veins );
    return mix( slate * texture( uIrradiance, N ).rgb, texture( uRoom, look ).rgb, snellFresnelExact( c, 1., 1.5 ) );
}

void main()
{
    vec3 color = light();
    outColor = vec4( uScreen ? toScreen( exp2( uExposure ) * color ) : sqrt( .25 * min( color, 4. ) ), 1. );
}
