#version 330 compatibility
uniform sampler3D Noise3;
uniform float uStripes, uNoiseAmp, uNoiseFreq;
in vec3 vPosition, vNormal;
const vec3 TO_LAMP = vec3( .48, .6, .64 );

// looks random, but the neighbours of a point have nothing to do with it
float random( vec3 p ) { return fract( sin( dot( p, vec3( 12.9898, 78.233, 37.719 ) ) ) * 43758.5453 ); }

void main()
{
    float x = vPosition.x + .1 * uNoiseAmp * random( vPosition );
    float stripe = .5 + .5 * cos( 6.2831853 * uStripes * x );
    float diffuse = max( dot( normalize( vNormal ), TO_LAMP ), 0. );
    gl_FragColor = vec4( ( .3 + .7 * diffuse ) * mix( vec3( .25, .22, .30 ), vec3( .95, .92, .87 ), stripe ), 1. );
}
