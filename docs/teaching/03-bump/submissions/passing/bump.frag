#version 330 compatibility
uniform float uLightX, uLightY, uHeight, uBumps;
in vec2 vAt;
const float PI = 3.14159265;

void main()
{
    float kx = PI * uBumps * vAt.x;
    float ky = PI * uBumps * vAt.y;
    // two tangents, and the normal at right angles to both
    vec3 Tx = vec3( 1., 0., -uHeight * PI * uBumps * sin( kx ) * cos( ky ) );
    vec3 Ty = vec3( 0., 1., -uHeight * PI * uBumps * cos( kx ) * sin( ky ) );
    vec3 normal = normalize( cross( Tx, Ty ) );
    vec3 toLight = normalize( vec3( uLightX - vAt.x, uLightY - vAt.y, 2. ) );
    float d = max( 0., dot( normal, toLight ) );
    gl_FragColor = vec4( .2 * vec3( .75, .60, .40 ) + .8 * d * vec3( .75, .60, .40 ), 1. );
}
