#version 330 compatibility

in vec3 vPosition, vNormal;

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
    vec3 point = vec3( -1.1, 2., .3 );      // the middle of the lamp
    float light = seen( vPosition, point ) * max( dot( N, normalize( point - vPosition ) ), 0. );
    gl_FragColor = vec4( ( .1 + .9 * light ) * COLOR, 1. );
}
