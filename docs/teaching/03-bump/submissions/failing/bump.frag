#version 330 compatibility
uniform float uLightX, uLightY, uHeight, uBumps;
in vec2 vAt;
const float PI = 3.14159265;

void main()
{
    float kx = PI * uBumps * vAt.x;
    float ky = PI * uBumps * vAt.y;
    vec3 N = normalize( vec3( -uHeight * PI * uBumps * sin( kx ) * cos( ky ),
                              -uHeight * PI * uBumps * cos( kx ) * sin( ky ), 1. ) );
    vec3 L = normalize( vec3( uLightX, uLightY, 2. ) );
    gl_FragColor = vec4( ( .2 + .8 * max( dot( N, L ), 0. ) ) * vec3( .75, .60, .40 ), 1. );
}
