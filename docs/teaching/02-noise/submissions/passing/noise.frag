#version 330 compatibility
uniform float uStripes, uNoiseAmp, uNoiseFreq;
uniform sampler3D Noise3;
in vec3 vPosition, vNormal;
const vec3 TO_LAMP = vec3( .48, .6, .64 );

// about -1 to 1
float turbulence( vec3 where )
{
    vec4 n = texture( Noise3, where ) - vec4( .5 );
    return dot( n, vec4( 1. ) );
}

void main()
{
    float moved = vPosition.x + uNoiseAmp * turbulence( vPosition * uNoiseFreq );
    float t = ( cos( 2. * 3.14159265 * moved * uStripes ) + 1. ) / 2.;
    vec3 color = t * vec3( .95, .92, .87 ) + ( 1. - t ) * vec3( .25, .22, .30 );
    float light = .3 + .7 * clamp( dot( normalize( vNormal ), TO_LAMP ), 0., 1. );
    gl_FragColor = vec4( light * color, 1. );
}
