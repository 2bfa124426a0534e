#version 330 compatibility

uniform samplerCube uAround;
uniform float uIndex;
uniform bool uMirror;

in vec3 vFromEye, vNormal;

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );

    // Bent where light enters, and by the same angle where it leaves the ball.
    vec3 T = refract( I, N, 1. / uIndex );
    T = 2. * dot( T, I ) * T - I;
    vec3 color = texture( uAround, T ).rgb;

    float c = clamp( -dot( I, N ), 0., 1. );
    float f0 = ( uIndex - 1. ) / ( uIndex + 1. );
    float share = f0 * f0 + ( 1. - f0 * f0 ) * pow( 1. - c, 5. );
    if( uMirror )
        color = mix( color, texture( uAround, reflect( I, N ) ).rgb, share );
    gl_FragColor = vec4( color, 1. );
}
