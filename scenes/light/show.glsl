// Colours by which scenes show numbers instead of the picture.

// A share of light: black 0 to white 1; below 0 blue and above 1 red, both impossible for a share.
vec3 showShare( float share )
{
    return share < 0. ? vec3( 0., 0., 1. ) : share > 1. ? vec3( 1., .1 / share, 0. ) : vec3( share );
}

// A direction: red to the right, green up, blue toward +Z.
vec3 showDirection( vec3 direction )
{
    return .5 + .5 * normalize( direction );
}

// An angle in degrees: black 0, violet 10, red 20, yellow 40, white 60 and more.
vec3 showDegrees( float angle )
{
    float x = clamp( angle / 60., 0., 1. );
    float violet = 1.5 * x * ( 1. - smoothstep( .25, .5, x ) );
    return clamp( vec3( 3. * x, 3. * x - 1., max( violet, 3. * x - 2. ) ), 0., 1. );
}
