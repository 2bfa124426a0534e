#version 330 compatibility

#include <snell/noise.glsl>

in vec2 vST;

float band( float x, float from, float to )
{
    return smoothstep( from - .004, from, x ) * smoothstep( to + .004, to, x );
}

// Rings, a meander between them, and flakes of gold leaf that wear off toward the poles.
void main()
{
    float t = vST.t, s = vST.s;
    float gold = band( t, .38, .395 ) + band( t, .605, .62 ) + band( t, .27, .278 ) + band( t, .722, .73 );

    vec2 cell = vec2( fract( 18. * s ), ( t - .41 ) / .18 );
    float inside = step( 0., cell.y ) * step( cell.y, 1. );
    float spiral = max( abs( cell.x - .5 ), abs( cell.y - .5 ) );
    gold += inside * step( .5, fract( 4.2 * spiral + .25 * cell.x ) );

    float around = 6.2831853 * s, up = 3.14159 * t;
    vec3 onBall = vec3( cos( around ) * sin( up ), cos( up ), sin( around ) * sin( up ) );
    float leaf = snellFractalNoise( 6. * onBall, 4 );
    float away = abs( t - .5 );
    gold += step( .23, away ) * smoothstep( .0, .05, leaf + .25 - away );
    gl_FragColor = vec4( vec3( clamp( gold, 0., 1. ) ), 1. );
}
