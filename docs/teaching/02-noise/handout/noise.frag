#version 330 compatibility

uniform float uStripes;

in vec3 vPosition, vNormal;

const vec3 TO_LAMP = vec3( .48, .6, .64 );      // of length 1
const vec3 VEIN = vec3( .25, .22, .30 ), STONE = vec3( .95, .92, .87 );

void main()
{
    float x = vPosition.x;
    float stripe = .5 + .5 * cos( 6.2831853 * uStripes * x );
    float diffuse = max( dot( normalize( vNormal ), TO_LAMP ), 0. );
    gl_FragColor = vec4( ( .3 + .7 * diffuse ) * mix( VEIN, STONE, stripe ), 1. );
}
