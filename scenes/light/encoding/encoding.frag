#version 330

#include <snell/color.glsl>
#include <snell/fresnel.glsl>

#if ENCODING == ENCODING_raw
uniform samplerCube uNumbers, uNumbersAround;
#define MIRRORED uNumbers
#define AROUND uNumbersAround
#else
uniform samplerCube uLight, uLightAround;
#define MIRRORED uLight
#define AROUND uLightAround
#endif
uniform float uIndex;
uniform vec3 uAlbedo;

in vec3 vNormal, vFromEye;

out vec4 outColor;

void main()
{
    vec3 E = normalize( vFromEye );
    vec3 N = normalize( vNormal );
    float share = snellFresnelExact( -dot( E, N ), 1., uIndex );
    vec3 mirrored = texture( MIRRORED, reflect( E, N ) ).rgb;
    vec3 around = texture( AROUND, N ).rgb;
#if ENCODING == ENCODING_raw
    outColor = vec4( mix( uAlbedo * around, mirrored, share ), 1. );
#else
    // A colour that was chosen on a display is a number of a display, too.
    outColor = vec4( snellEncode( mix( snellDecode( uAlbedo ) * around, mirrored, share ) ), 1. );
#endif
}
