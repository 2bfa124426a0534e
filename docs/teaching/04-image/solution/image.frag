#version 330 compatibility

uniform sampler2D uPicture;
uniform float uSharpness, uGrey, uEdges;

in vec2 vST;

const vec3 LUMINANCE = vec3( .2126, .7152, .0722 );

vec3 texel( float right, float up )
{
    return texture( uPicture, vST + vec2( right, up ) / vec2( textureSize( uPicture, 0 ) ) ).rgb;
}

float brightness( float right, float up )
{
    return dot( texel( right, up ), LUMINANCE );
}

void main()
{
    vec3 color = texel( 0., 0. );
    vec3 blurred = ( texel( 1., 0. ) + texel( -1., 0. ) + texel( 0., 1. ) + texel( 0., -1. ) ) / 4.;
    color = mix( blurred, color, 1. + uSharpness );
    color = mix( color, vec3( dot( color, LUMINANCE ) ), uGrey );

    vec2 change = vec2( brightness( 1., 0. ) - brightness( -1., 0. ), brightness( 0., 1. ) - brightness( 0., -1. ) );
    color = mix( color, vec3( 2. * length( change ) ), uEdges );
    gl_FragColor = vec4( clamp( color, 0., 1. ), 1. );
}
