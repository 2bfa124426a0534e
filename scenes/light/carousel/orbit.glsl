// Centre and radius of ball 0, 1 or 2 at `turn`, which has a period of 1.
vec4 orbit( int ball, float turn )
{
    float angle = 6.2831853 * ( turn + float( ball ) / 3. );
    return vec4( 2.2 * sin( angle ), .45 * sin( 2. * angle + float( ball ) ), 2.2 * cos( angle ), .5 - .08 * float( ball ) );
}

vec3 paint( int ball )
{
    return ball == 0 ? vec3( .95, .30, .08 ) : ball == 1 ? vec3( .10, .55, .80 ) : vec3( .98, .78, .15 );
}

// Light from the window, and a little from all sides.
vec3 lit( vec3 color, vec3 N )
{
    return color * ( .40 + .60 * max( dot( N, normalize( vec3( -.4, .8, .55 ) ) ), 0. ) + .25 * max( N.y, 0. ) );
}
