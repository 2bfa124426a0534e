#version 330 compatibility

uniform float uHeight, uWaves, uFade;
uniform bool uMove;
uniform float Timer;        // 0 to 1, again and again; snell sets it

out vec3 vNormal, vPosition;        // in eye coordinates

const float TWO_PI = 6.2831853;

void main()
{
    vec3 p = gl_Vertex.xyz;
    float r = length( p.xz );               // distance from the middle
    float phase = TWO_PI * ( uWaves * r - ( uMove ? Timer : 0. ) );

    // The height is a product: waves, times what fades them.
    float fade = exp( -uFade * r );
    p.y += uHeight * fade * sin( phase );

    // Its slope away from the middle, by the product rule.
    float slope = uHeight * fade * ( TWO_PI * uWaves * cos( phase ) - uFade * sin( phase ) );

    // Of a height y(x,z), ( -dy/dx, 1, -dy/dz ) is normal to the surface. In the very middle no direction leads away.
    vec2 away = r > 0. ? p.xz / r : vec2( 0. );
    vNormal = gl_NormalMatrix * vec3( -slope * away.x, 1., -slope * away.y );
    vPosition = ( gl_ModelViewMatrix * vec4( p, 1. ) ).xyz;
    gl_Position = gl_ModelViewProjectionMatrix * vec4( p, 1. );
}
