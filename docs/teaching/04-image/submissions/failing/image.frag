#version 330 compatibility
uniform sampler2D uPicture;
uniform float uSharpness, uGrey, uEdges;
in vec2 vST;

void main()
{
    // a picture of 512 texels, as in the book
    vec2 dx = vec2( 1. / 512., 0. ), dy = vec2( 0., 1. / 512. );
    vec3 c = texture( uPicture, vST ).rgb;
    vec3 blurred = ( texture( uPicture, vST + dx ).rgb + texture( uPicture, vST - dx ).rgb
                   + texture( uPicture, vST + dy ).rgb + texture( uPicture, vST - dy ).rgb ) / 4.;
    vec3 color = mix( c, blurred, uSharpness );
    float grey = ( color.r + color.g + color.b ) / 3.;
    color = mix( color, vec3( grey ), uGrey );
    gl_FragColor = vec4( color, 1. );
}
