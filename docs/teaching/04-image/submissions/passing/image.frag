#version 330 compatibility
uniform sampler2D uPicture;
uniform float uSharpness, uGrey, uEdges;
in vec2 vST;
const vec3 W = vec3( .2126, .7152, .0722 );

void main()
{
    ivec2 size = textureSize( uPicture, 0 );
    vec2 dx = vec2( 1. / float( size.x ), 0. );
    vec2 dy = vec2( 0., 1. / float( size.y ) );
    vec3 c = texture( uPicture, vST ).rgb;
    vec3 east = texture( uPicture, vST + dx ).rgb;
    vec3 west = texture( uPicture, vST - dx ).rgb;
    vec3 north = texture( uPicture, vST + dy ).rgb;
    vec3 south = texture( uPicture, vST - dy ).rgb;
    vec3 laplace = east + west + north + south - 4. * c;
    vec3 color = c - uSharpness * laplace / 4.;
    color = ( 1. - uGrey ) * color + uGrey * dot( W, color );
    float gx = dot( W, east ) - dot( W, west );
    float gy = dot( W, north ) - dot( W, south );
    color = ( 1. - uEdges ) * color + uEdges * 2. * sqrt( gx * gx + gy * gy );
    gl_FragColor = vec4( color, 1. );
}
