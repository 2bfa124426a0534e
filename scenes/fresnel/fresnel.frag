#version 330

uniform samplerCube uSurroundings;
uniform float uIndex;       // of the ball; air is 1
uniform int uFormula;
uniform float uBias, uScale, uPower;
uniform bool uShowPart;

in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

// Each returns the mirrored part of light that comes from air, 0 to 1; c is the cosine of the angle of incidence,
// between 0 and 1.

float straightOn( float n )
{
    float r = ( 1. - n ) / ( 1. + n );
    return r * r;
}

float schlick( float c, float n )
{
    float f0 = straightOn( n ), away = 1. - c, away2 = away * away;
    return f0 + ( 1. - f0 ) * away2 * away2 * away;     // power 5, without pow()
}

float byHand( float c )
{
    return clamp( uBias + uScale * pow( 1. - c, uPower ), 0., 1. );
}

// The mean of both polarisations. n >= 1, so there is no total reflection to look after.
float exact( float c, float n )
{
    float t = sqrt( ( n - 1. ) * ( n + 1. ) + c * c );   // n times the cosine inside
    float s = ( c - t ) / ( c + t );
    float p = ( n * n * c - t ) / ( n * n * c + t );
    return .5 * ( s * s + p * p );
}

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );
    float c = clamp( -dot( I, N ), 1.e-4, 1. );

    float part;
    if( uFormula == 0 )
        part = straightOn( uIndex );
    else if( uFormula == 1 )
        part = schlick( c, uIndex );
    else if( uFormula == 2 )
        part = byHand( c );
    else
        part = exact( c, uIndex );

    vec3 mirrored = texture( uSurroundings, reflect( I, N ) ).rgb;
    // refract() wants index before / index behind.
    vec3 transmitted = texture( uSurroundings, refract( I, N, 1. / uIndex ) ).rgb;

    vec3 color = mix( transmitted, mirrored, part );
    outColor = vec4( uShowPart ? vec3( part ) : color, 1. );
}
