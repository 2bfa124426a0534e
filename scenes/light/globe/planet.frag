#version 330 compatibility

#include <snell/noise.glsl>

in vec3 vDirection;

// An invented world, by direction from its centre: sea, land, mountains, ice and clouds made of noise.
void main()
{
    vec3 d = normalize( vDirection );
    float height = snellFractalNoise( 1.5 * d + 3., 6 ) - .03;
    float relief = snellFractalNoise( 9. * d, 4 ), latitude = abs( d.y );

    vec3 sea = mix( vec3( .01, .05, .17 ), vec3( .05, .27, .36 ), smoothstep( -.25, .02, height ) );
    float dry = 1. - smoothstep( -.25, .25, relief + .9 * ( latitude - .35 ) );
    vec3 green = mix( vec3( .06, .20, .05 ), vec3( .55, .44, .22 ), dry );
    vec3 land = mix( green, vec3( .33, .27, .23 ), smoothstep( .16, .30, height ) );
    land = mix( land, vec3( .95 ), smoothstep( .34, .40, height + .1 * relief ) );
    vec3 color = mix( sea, land, smoothstep( .015, .03, height ) );
    color = mix( color, vec3( .92, .95, .98 ), smoothstep( .80, .88, latitude + .12 * relief ) );

    float clouds = snellFractalNoise( vec3( 1.8, 4.2, 1.8 ) * d + 20., 6 );
    color = mix( color, vec3( 1. ), .8 * smoothstep( .12, .45, clouds ) );
    gl_FragColor = vec4( color, 1. );
}
