#version 330

#include <snell/environment.glsl>
#include <snell/ray.glsl>
#include <snell/fresnel.glsl>
#include "orbit.glsl"
#include "../show.glsl"

uniform float uMirror;
uniform int uView;
#if MAP == MAP_moving
uniform samplerCube uMoving;
#define uSeen uMoving
#else
uniform samplerCube uStill;
#define uSeen uStill
#endif
#if NEAR == NEAR_traced
uniform float Timer;
#endif

in vec3 vPosition;
in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

vec3 surroundings( vec3 from, vec3 direction )
{
#if NEAR == NEAR_infinite
    return texture( uSeen, direction ).rgb;
#else
    vec3 color = texture( uSeen, snellBoxDirection( from, direction, vec3( 5. ), vec3( 0. ) ) ).rgb;
    float nearest = 1.e9;
    for( int i = 0; i < 3; i++ )
    {
        vec4 ball = orbit( i, Timer );
        float enter, leave;
        if( snellHitSphere( from, direction, ball.xyz, ball.w, enter, leave ) && enter > 0. && enter < nearest )
        {
            nearest = enter;
            vec3 N = ( from + enter * direction - ball.xyz ) / ball.w;
            color = lit( paint( i ), N );
        }
    }
    return color;
#endif
}

void main()
{
    vec3 N = normalize( vNormal ), I = normalize( vFromEye );
    vec3 mirrored = reflect( I, N );
    float share = mix( snellFresnelExact( -dot( I, N ), 1., 1.5 ), 1., uMirror );
    vec3 color = share * surroundings( vPosition, mirrored );
    outColor = vec4( uView == 1 ? showDirection( mirrored ) : color, 1. );
}
