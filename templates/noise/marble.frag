#version 330 compatibility

uniform sampler3D Noise3;       // snell makes it and sets it; the scene does not
uniform float uStripes, uNoiseAmp, uNoiseFreq;
uniform vec3 uVein, uStone;

in vec3 vPosition, vNormal;

const vec3 TO_LAMP = vec3( .48, .6, .64 );      // a direction of length 1
const float TWO_PI = 6.2831853;

void main()
{
    // Four octaves, one in each channel: each twice as fine and half as strong as the one before. All are around .5,
    // so their sum is around 2. Minus 2 it is around 0, about -1 to 1.
    vec4 octaves = texture( Noise3, uNoiseFreq * vPosition );
    float noise = octaves.r + octaves.g + octaves.b + octaves.a - 2.;

    // Straight stripes along x would be sin( TWO_PI * uStripes * x ). Noise moves x.
    float x = vPosition.x + uNoiseAmp * noise;
    float stripe = .5 + .5 * sin( TWO_PI * uStripes * x );

    vec3 color = mix( uVein, uStone, smoothstep( 0., .6, stripe ) );
    float diffuse = max( dot( normalize( vNormal ), TO_LAMP ), 0. );
    gl_FragColor = vec4( ( .3 + .7 * diffuse ) * color, 1. );
}
