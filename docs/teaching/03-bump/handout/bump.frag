#version 330 compatibility

uniform float uLightX, uLightY;

in vec2 vAt;

const vec3 COLOR = vec3( .75, .60, .40 );

void main()
{
    vec3 N = vec3( 0., 0., 1. );
    vec3 L = normalize( vec3( uLightX, uLightY, 2. ) - vec3( vAt, 0. ) );
    gl_FragColor = vec4( ( .2 + .8 * max( dot( N, L ), 0. ) ) * COLOR, 1. );
}
