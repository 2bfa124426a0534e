#version 330 compatibility

uniform vec3 uWater;

in vec3 vNormal, vPosition;

const vec3 LAMP = vec3( 2., 3., -2. );      // in eye coordinates

void main()
{
    vec3 N = normalize( vNormal );
    vec3 L = normalize( LAMP - vPosition );     // from the surface to the lamp
    vec3 E = normalize( -vPosition );           // from the surface to the eye, which is the origin
    vec3 H = normalize( L + E );                // a mirror with this normal would show the lamp

    float diffuse = max( dot( N, L ), 0. );
    float shine = pow( max( dot( N, H ), 0. ), 60. );
    gl_FragColor = vec4( ( .4 + .6 * diffuse ) * uWater + .8 * shine, 1. );
}
