// The sRGB curve (IEC 61966-2-1): between light and the numbers from 0 to 1 that displays and 8-bit pictures hold.
// Both functions are odd, so that differences and negative light keep their sign.

vec3 snellEncode( vec3 light )
{
    vec3 c = abs( light );
    vec3 high = 1.055 * pow( max( c, 1e-9 ), vec3( 1. / 2.4 ) ) - .055;
    return sign( light ) * mix( high, 12.92 * c, vec3( lessThanEqual( c, vec3( .0031308 ) ) ) );
}

vec3 snellDecode( vec3 numbers )
{
    vec3 c = abs( numbers );
    vec3 high = pow( ( c + .055 ) / 1.055, vec3( 2.4 ) );
    return sign( numbers ) * mix( high, c / 12.92, vec3( lessThanEqual( c, vec3( .04045 ) ) ) );
}
