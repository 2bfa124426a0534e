#version 330 compatibility
in vec3 vPosition, vNormal;
const vec3 COLOR = vec3( .85, .80, .70 );

float seen( vec3 from, vec3 to )
{
    vec3 d = to - from;
    float along = clamp( -dot( from, d ) / dot( d, d ), 0., 1. );
    return length( from + along * d ) < .59 ? 0. : 1.;
}

void main()
{
    vec3 N = normalize( vNormal );
    float light = 0.;
    float cell = 1. / float( LAMP_VALUE );
    for( float x = .5 * cell; x < 1.; x += cell )
        for( float z = .5 * cell; z < 1.; z += cell )
        {
            vec3 point = vec3( x - 1.6, 2., z - .2 );
            light += cell * cell * seen( vPosition, point ) * max( dot( N, normalize( point - vPosition ) ), 0. );
        }
    gl_FragColor = vec4( ( .1 + .9 * light ) * COLOR, 1. );
}
