#version 330 compatibility

uniform samplerCube uRoom;
uniform float uIndex;       // index of the glass; the room is air, 1
uniform float uMix;         // 0 glass ... 1 mirror
uniform float uWhiteMix;
uniform bool uBothSides;
uniform bool uNearWalls;

in vec3 vPosition;
in vec3 vNormal;
in vec3 vEye;

const vec3 WHITE = vec3( 1., 1., 1. );
const float HALF_ROOM = 5.;

// The colour seen from `from` in `direction`. A cube map is right for its centre only, so the lookup uses the
// direction from the centre to the point where the ray meets the walls. Precondition: `from` is inside the room.
vec3 lookAround( vec3 from, vec3 direction )
{
    vec3 toWalls = ( HALF_ROOM - sign( direction ) * from ) / max( abs( direction ), 1.e-20 );
    float nearest = min( toWalls.x, min( toWalls.y, toWalls.z ) );
    return texture( uRoom, uNearWalls ? from + nearest * direction : direction ).rgb;
}

// The share of light that a surface mirrors, for light from air at an angle of incidence with cosine c:
// Fresnel's equations, both polarisations, for index n >= 1.
float fresnel( float c, float n )
{
    float t = sqrt( ( n - 1. ) * ( n + 1. ) + c * c );               // n times the cosine inside
    float across = ( c - t ) / ( c + t );
    float along = ( n * n * c - t ) / ( n * n * c + t );
    return .5 * ( across * across + along * along );
}

void main()
{
    // Interpolation shortens the normal, and reflect() and refract() expect unit vectors.
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vPosition - vEye );
    float c = clamp( -dot( I, N ), 1.e-4, 1. );

    vec3 reflected = lookAround( vPosition, reflect( I, N ) );

    // refract() takes the ratio of the indices, outside / inside: below 1 for light that enters glass.
    vec3 T = refract( I, N, 1. / uIndex );
    vec3 exit = vPosition;
    if( uBothSides )
    {
        exit = vPosition - 2. * dot( vPosition, T ) * T;             // the other end of the chord through the ball
        T = 2. * dot( T, I ) * T - I;                                // bent again by the same angle, by symmetry
    }
    vec3 refracted = mix( lookAround( exit, T ), WHITE, uWhiteMix );

    vec3 glass = mix( refracted, reflected, fresnel( c, uIndex ) );
    vec3 color = mix( glass, reflected, uMix );
    gl_FragColor = vec4( mix( color, WHITE, uWhiteMix * .5 ), 1. );
}
