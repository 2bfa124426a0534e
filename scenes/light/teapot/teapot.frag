#version 330

#include <snell/fresnel.glsl>
#include "../show.glsl"

uniform samplerCube uSurroundings;
uniform vec3 uMetal;
uniform float uPolish;
uniform int uView;

in vec3 vNormal, vRightNormal;
in vec3 vFromEye;

out vec4 outColor;

const vec3 TO_SUN = vec3( -.50, .62, -.60 );

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    vec3 toMirrored = reflect( I, N );      // I - 2 (I.N) N
    vec3 mirrored = texture( uSurroundings, toMirrored ).rgb;

    // Polished metal shows its colour at normal incidence and turns white toward the edge.
    vec3 metal = mirrored * mix( uMetal, vec3( 1. ), snellFresnelSchlick5( -dot( I, N ), 0. ) );
    float sun = max( dot( N, normalize( TO_SUN ) ), 0. );
    vec3 paint = uMetal * ( .25 + .75 * sun );

    vec3 color = mix( paint, metal, uPolish );
    if( uView == 1 )
        color = showDirection( toMirrored );
    if( uView == 2 )
        color = showDegrees( degrees( snellAngle( N, normalize( vRightNormal ) ) ) );
    outColor = vec4( color, 1. );
}
