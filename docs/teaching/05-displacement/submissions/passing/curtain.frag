#version 330 compatibility

in vec3 vNormal, vPosition;

const vec3 LAMP = vec3( -3., 2., 0. );      // in eye coordinates
const vec3 COLOR = vec3( .70, .15, .20 );

void main()
{
    // The back of the curtain has the opposite normal.
    vec3 N = normalize( gl_FrontFacing ? vNormal : -vNormal );
    float diffuse = max( dot( N, normalize( LAMP - vPosition ) ), 0. );
    gl_FragColor = vec4( ( .2 + .8 * diffuse ) * COLOR, 1. );
}
