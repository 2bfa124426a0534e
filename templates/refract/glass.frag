#version 330 compatibility

uniform samplerCube uSky;
uniform float uIndex;
uniform bool uBothSides, uMirror;
uniform vec3 uTint;

in vec3 vFromEye, vNormal;

void main()
{
    // reflect() and refract() expect directions of length 1; interpolation has shortened the normal.
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );

    // The third argument is a ratio of two indices, outside / inside: below 1 for light that enters glass.
    vec3 T = refract( I, N, 1. / uIndex );

    // Within a ball, light meets the other side at the angle at which it left this one. So it is bent once more by the
    // same angle, in the same plane: T is halfway between I and the direction outside.
    if( uBothSides )
        T = 2. * dot( T, I ) * T - I;
    vec3 color = uTint * texture( uSky, T ).rgb;

    // Schlick's formula: glass mirrors 4 % of the light that meets it head-on, and all of it at the rim.
    float c = clamp( -dot( I, N ), 0., 1. );
    float f0 = ( uIndex - 1. ) / ( uIndex + 1. );
    f0 *= f0;
    float share = f0 + ( 1. - f0 ) * pow( 1. - c, 5. );
    if( uMirror )
        color = mix( color, texture( uSky, reflect( I, N ) ).rgb, share );

    gl_FragColor = vec4( color, 1. );
}
