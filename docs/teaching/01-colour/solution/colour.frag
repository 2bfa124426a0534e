#version 330 compatibility

uniform vec3 uColor;
uniform float uKa, uKd, uKs, uShininess;

in vec3 vNormal, vPosition;

const vec3 LAMP = vec3( 3., 4., 2. );       // in eye coordinates

void main()
{
    vec3 N = normalize( vNormal );
    vec3 L = normalize( LAMP - vPosition );
    vec3 E = normalize( -vPosition );       // the eye is at the origin
    vec3 R = reflect( -L, N );

    float diffuse = max( dot( N, L ), 0. );
    float specular = pow( max( dot( R, E ), 0. ), uShininess );

    // Paint takes its colour away from the light that it scatters. What shines is the lamp's own light.
    gl_FragColor = vec4( ( uKa + uKd * diffuse ) * uColor + uKs * specular * vec3( 1. ), 1. );
}
