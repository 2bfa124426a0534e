#version 330 compatibility
uniform samplerCube uAround;
uniform float uIndex;
uniform bool uMirror;
in vec3 vFromEye, vNormal;

void main()
{
    vec3 color = texture( uAround, refract( vFromEye, vNormal, uIndex ) ).rgb;
    if( uMirror )
        color = mix( color, texture( uAround, reflect( vFromEye, vNormal ) ).rgb, .1 );
    gl_FragColor = vec4( color, 1. );
}
