#version 330 compatibility
uniform float uKa, uKd, uKs, uShininess;
uniform vec3 uColor;
in vec3 vNormal, vPosition;
const vec3 LAMP = vec3( 3., 4., 2. );

void main()
{
    vec3 normal = normalize( vNormal );
    vec3 light = normalize( LAMP - vPosition );
    vec3 ambient = uKa * uColor;
    float d = dot( normal, light );
    vec3 diffuse = uKd * max( d, 0. ) * uColor;
    float s = 0.;
    if( d > 0. )            // no highlight where the lamp does not shine
    {
        vec3 mirrored = normalize( 2. * d * normal - light );
        s = pow( max( dot( mirrored, normalize( -vPosition ) ), 0. ), uShininess );
    }
    gl_FragColor = vec4( ambient + diffuse + uKs * s, 1. );
}
