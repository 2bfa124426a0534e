#version 330 compatibility

uniform float uLightX, uLightY, uHeight, uBumps;

in vec2 vAt;

const vec3 COLOR = vec3( .75, .60, .40 );

void main()
{
    // The height is uHeight * cos( k x ) * cos( k y ); these are its slopes along x and y.
    float k = 3.14159265 * uBumps;
    vec2 a = k * vAt;
    vec2 slope = -uHeight * k * vec2( sin( a.x ) * cos( a.y ), cos( a.x ) * sin( a.y ) );

    vec3 N = normalize( vec3( -slope, 1. ) );
    vec3 L = normalize( vec3( uLightX, uLightY, 2. ) - vec3( vAt, 0. ) );
    gl_FragColor = vec4( ( .2 + .8 * max( dot( N, L ), 0. ) ) * COLOR, 1. );
}
