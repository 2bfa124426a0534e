#version 330

uniform samplerCube uRoom;
uniform float uIndex;       // for yellow light, 587.6 nm
uniform float uAbbe;

in vec3 vPosition;
in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

const float HALF_ROOM = 5.;

// The wavelengths, in micrometres, that stand best for a screen's red, green and blue.
const vec3 WAVELENGTH = vec3( .611, .549, .464 );

// Cauchy's formula n = a + b / wavelength^2. Abbe's number is (n yellow - 1) / (n blue - n red), measured at three
// lines of the spectrum; that gives b.
vec3 indices()
{
    const float yellow = .58756, blue = .48613, red = .65627;
    float b = ( uIndex - 1. ) / uAbbe / ( 1. / ( blue * blue ) - 1. / ( red * red ) );
    return uIndex + b * ( 1. / ( WAVELENGTH * WAVELENGTH ) - 1. / ( yellow * yellow ) );
}

vec3 room( vec3 from, vec3 direction )
{
    vec3 toWalls = ( HALF_ROOM - sign( direction ) * from ) / max( abs( direction ), 1.e-20 );
    float nearest = min( toWalls.x, min( toWalls.y, toWalls.z ) );
    return texture( uRoom, from + nearest * direction ).rgb;
}

// Through the whole ball, in at vPosition and out at the other side, for one index.
vec3 through( vec3 I, vec3 N, float n )
{
    vec3 T = refract( I, N, 1. / max( n, 1. ) );
    vec3 exit = vPosition - 2. * dot( vPosition, T ) * T;   // the ball's centre is the origin
    return room( exit, 2. * dot( T, I ) * T - I );
}

float fresnel( float c, float n )
{
    float t = sqrt( max( ( n - 1. ) * ( n + 1. ), 0. ) + c * c );
    float s = ( c - t ) / ( c + t );
    float p = ( n * n * c - t ) / ( n * n * c + t );
    return .5 * ( s * s + p * p );
}

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    float c = clamp( -dot( I, N ), 1.e-4, 1. );

    vec3 n = indices();     // blue has the largest: it is bent most
    vec3 split = vec3( through( I, N, n.r ).r, through( I, N, n.g ).g, through( I, N, n.b ).b );
    vec3 mirrored = room( vPosition, reflect( I, N ) );

    outColor = vec4( mix( split, mirrored, fresnel( c, uIndex ) ), 1. );
}
