#version 330 compatibility

uniform vec3 uColor;

in vec3 gNormal;

const vec3 TO_LAMP = vec3( .48, .6, .64 );      // a direction of length 1

void main()
{
    // Behind gaps the inside is seen; there the normal points away from the eye.
    vec3 N = normalize( gl_FrontFacing ? gNormal : -gNormal );
    float diffuse = max( dot( N, TO_LAMP ), 0. );
    vec3 color = gl_FrontFacing ? uColor : .5 * uColor;
    gl_FragColor = vec4( ( .25 + .75 * diffuse ) * color, 1. );
}
