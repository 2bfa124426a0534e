#version 330

layout(location = 0) out vec4 o_color;

in vec3 v_fromEye;
in vec3 v_normal;

uniform samplerCube u_environmentTexture;
uniform float uIndex, uSpread;
uniform float uBody;
uniform vec3 uBodyColor;

// Light that falls on a surface from all sides: the mean of the surroundings over the half sphere that the surface
// sees, the directions near the normal counting most. A few dozen looks are enough for something so smooth.
vec3 lightFromAround( vec3 N )
{
    const int LOOKS = 48;
    const float GOLDEN_ANGLE = 2.39996323;
    vec3 sum = vec3( 0. );
    for( int i = 0; i < LOOKS; i++ )
    {
        // Points spread evenly over a ball standing on the surface: seen from its foot, they lie as the cosine asks.
        float z = 1. - ( 2. * float( i ) + 1. ) / float( LOOKS );
        float r = sqrt( 1. - z * z ), a = GOLDEN_ANGLE * float( i );
        sum += texture( u_environmentTexture, N + vec3( r * cos( a ), r * sin( a ), z ) ).rgb;
    }
    return sum / float( LOOKS );
}

// The mirrored part, for light from air: c is the cosine of the angle of incidence in (0,1], n >= 1.
float fresnel( float c, float n )
{
    float t = sqrt( ( n - 1. ) * ( n + 1. ) + c * c );
    float s = ( c - t ) / ( c + t );
    float p = ( n * n * c - t ) / ( n * n * c + t );
    return .5 * ( s * s + p * p );
}

void main(void)
{
    vec3 N = normalize( v_normal );
    vec3 I = normalize( v_fromEye );       // from the eye to the surface, as reflect() and refract() expect
    float c = clamp( -dot( I, N ), 1.e-4, 1. );

    vec3 mirrored = texture( u_environmentTexture, reflect( I, N ) ).rgb;

    // Blue has the largest index and is bent most. The ratio that refract() takes is air / glass.
    vec3 eta = 1. / max( uIndex + vec3( -uSpread, 0., uSpread ), 1. );
    vec3 transmitted = vec3( texture( u_environmentTexture, refract( I, N, eta.r ) ).r,
                             texture( u_environmentTexture, refract( I, N, eta.g ) ).g,
                             texture( u_environmentTexture, refract( I, N, eta.b ) ).b );

    vec3 body = uBodyColor * lightFromAround( N );

    // The more the surface turns away, the more it mirrors.
    vec3 color = mix( mix( transmitted, body, uBody ), mirrored, fresnel( c, max( uIndex, 1. ) ) );
    o_color = vec4( color, 1. );
}
