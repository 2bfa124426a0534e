#version 330 compatibility

uniform sampler2D uPicture;

in vec2 vST;

void main()
{
    gl_FragColor = texture( uPicture, vST );
}
