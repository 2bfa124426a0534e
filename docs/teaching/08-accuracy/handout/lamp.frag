#version 330 compatibility

in vec3 vPosition, vNormal;

// The light of the square lamp is the mean over LAMP x LAMP points of it.
const int LAMP = 24;

const vec3 COLOR = vec3( .85, .80, .70 );

// 0 if the ball is between the point and the lamp's. Its triangles lie a little within the radius of .6.
float seen( vec3 from, vec3 to )
{
    vec3 d = to - from;
    float along = clamp( -dot( from, d ) / dot( d, d ), 0., 1. );      // of the point of the way nearest the middle
    return length( from + along * d ) < .59 ? 0. : 1.;
}

void main()
{
    vec3 N = normalize( vNormal );
    float light = 0.;
    for( int i = 0; i < LAMP; i++ )
        for( int k = 0; k < LAMP; k++ )
        {
            // The middles of equal cells.
            vec2 at = ( vec2( float( i ), float( k ) ) + .5 ) / float( LAMP );
            vec3 point = vec3( -1.6 + at.x, 2., -.2 + at.y );
            light += seen( vPosition, point ) * max( dot( N, normalize( point - vPosition ) ), 0. );
        }
    light /= float( LAMP * LAMP );
    gl_FragColor = vec4( ( .1 + .9 * light ) * COLOR, 1. );
}
