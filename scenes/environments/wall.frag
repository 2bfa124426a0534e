#version 330 compatibility

uniform sampler2D uPicture;

in vec2 vST;

void main()
{
    gl_FragColor = vec4( texture( uPicture, vST ).rgb, 1. );
}
