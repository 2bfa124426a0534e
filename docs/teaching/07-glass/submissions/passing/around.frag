#version 330 compatibility

in vec3 vDirection;

// Sky above, a chequered floor below, and a row of red columns.
void main()
{
    vec3 d = normalize( vDirection );
    vec3 color = mix( vec3( .85, .92, 1. ), vec3( .25, .50, .85 ), clamp( d.y, 0., 1. ) );
    if( d.y < 0. )
    {
        vec2 at = d.xz / max( -d.y, .08 );
        float chequer = mod( floor( at.x ) + floor( at.y ), 2. );
        color = mix( vec3( .30, .32, .30 ), vec3( .80, .80, .75 ), chequer );
    }
    float around = atan( d.z, d.x ) * 8. / 3.14159265;
    if( abs( fract( around ) - .5 ) < .12 && d.y > -.05 && d.y < .3 )
        color = vec3( .75, .20, .15 );
    gl_FragColor = vec4( color, 1. );
}
