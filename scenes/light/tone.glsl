// From light to a screen: a shoulder for the bright parts (Narkowicz 2015), then sRGB's curve.
vec3 toScreen( vec3 light )
{
    vec3 x = max( light, 0. );
    vec3 toned = clamp( x * ( 2.51 * x + .03 ) / ( x * ( 2.43 * x + .59 ) + .14 ), 0., 1. );
    return mix( 12.92 * toned, 1.055 * pow( max( toned, 1.e-4 ), vec3( 1. / 2.4 ) ) - .055, step( .0031308, toned ) );
}
