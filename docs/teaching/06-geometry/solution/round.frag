#version 400 compatibility

in vec3 gNormal;

const vec3 TO_LAMP = vec3( .48, .6, .64 );      // of length 1
const vec3 COLOR = vec3( .25, .55, .35 );

void main()
{
    vec3 N = normalize( gl_FrontFacing ? gNormal : -gNormal );
    gl_FragColor = vec4( ( .25 + .75 * max( dot( N, TO_LAMP ), 0. ) ) * ( gl_FrontFacing ? COLOR : .4 * COLOR ), 1. );
}
