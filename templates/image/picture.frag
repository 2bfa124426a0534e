#version 330 compatibility

uniform sampler2D uPicture;
uniform float uBrightness, uContrast, uSaturation, uSharpness, uEdges;

in vec2 vST;

const vec3 GREY = vec3( .5 );
const vec3 LUMINANCE = vec3( .2126, .7152, .0722 );     // how bright red, green and blue look

// The picture, some texels to the side.
vec3 texel( float right, float up )
{
    return texture( uPicture, vST + vec2( right, up ) / vec2( textureSize( uPicture, 0 ) ) ).rgb;
}

// How fast the luminance changes: Sobel's operator, the length of ( change to the right, change upward ).
float edges()
{
    float nw = dot( texel( -1., 1. ), LUMINANCE ), n = dot( texel( 0., 1. ), LUMINANCE );
    float ne = dot( texel( 1., 1. ), LUMINANCE ), e = dot( texel( 1., 0. ), LUMINANCE );
    float se = dot( texel( 1., -1. ), LUMINANCE ), s = dot( texel( 0., -1. ), LUMINANCE );
    float sw = dot( texel( -1., -1. ), LUMINANCE ), w = dot( texel( -1., 0. ), LUMINANCE );
    return length( vec2( ne + 2. * e + se - nw - 2. * w - sw, nw + 2. * n + ne - sw - 2. * s - se ) );
}

void main()
{
    vec3 color = texel( 0., 0. );

    // A blurred copy: the mean of nine texels. mix() away from it sharpens.
    vec3 blurred = vec3( 0. );
    for( float up = -1.; up <= 1.; up++ )
        for( float right = -1.; right <= 1.; right++ )
            blurred += texel( right, up ) / 9.;
    color = mix( blurred, color, 1. + uSharpness );

    // mix( a, b, t ) for t above 1 goes beyond b. So each of these is a mix with what is removed at 0.
    color = mix( vec3( dot( color, LUMINANCE ) ), color, uSaturation );
    color = mix( GREY, color, uContrast );
    color = mix( vec3( 0. ), color, uBrightness );

    color = mix( color, vec3( edges() ), uEdges );
    gl_FragColor = vec4( clamp( color, 0., 1. ), 1. );
}
