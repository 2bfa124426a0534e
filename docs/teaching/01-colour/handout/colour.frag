#version 330 compatibility

uniform vec3 uColor;

in vec3 vNormal, vPosition;

const vec3 LAMP = vec3( 3., 4., 2. );       // in eye coordinates

void main()
{
    gl_FragColor = vec4( uColor, 1. );
}
