#version 330

#include <snell/irradiance.glsl>

uniform samplerCube uAround;
#if AMBIENT == AMBIENT_small_map
uniform samplerCube uSmall;
#elif AMBIENT == AMBIENT_constant || AMBIENT == AMBIENT_harmonics
uniform vec3 uHarmonics[9];     // coefficients of the cube map that Irradiance names; set by snell
#elif AMBIENT == AMBIENT_irradiance
uniform samplerCube uIrradiance;
#endif
uniform vec3 uAlbedo;
uniform int uView;

in vec3 vNormal;

out vec4 outColor;

void main()
{
    vec3 N = normalize( vNormal );
#if AMBIENT == AMBIENT_constant
    vec3 light = snellIrradianceHarmonics( uHarmonics, N, 0 );
#elif AMBIENT == AMBIENT_small_map
    vec3 light = textureLod( uSmall, N, 5. ).rgb;
#elif AMBIENT == AMBIENT_harmonics
    vec3 light = snellIrradianceHarmonics( uHarmonics, N, 2 );
#elif AMBIENT == AMBIENT_irradiance
    vec3 light = texture( uIrradiance, N ).rgb;
#else
    vec3 light = snellIrradianceQuadrature( uAround, N, 256 );
#endif

    vec3 color = uAlbedo * light;
    if( uView == 1 )
        color = light;
    if( uView == 2 )
        color = .5 + 2. * ( light - snellIrradianceQuadrature( uAround, N, 256 ) );
    outColor = vec4( color, 1. );
}
