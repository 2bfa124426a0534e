#version 330 compatibility
uniform vec3 uColor;
uniform float uKa, uKd, uKs, uShininess;
in vec3 vNormal, vPosition;
const vec3 LAMP = vec3( 3., 4., 2. );

void main()
{
    vec3 L = normalize( LAMP - vPosition );
    vec3 R = reflect( -L, vNormal );
    float diffuse = dot( vNormal, L );
    float specular = pow( dot( R, normalize( -vPosition ) ), uShininess );
    gl_FragColor = vec4( ( uKa + diffuse + uKs * specular ) * uColor, 1. );
}
