#version 330 compatibility
uniform samplerCube uAround;
uniform float uIndex;
uniform bool uMirror;
in vec3 vFromEye, vNormal;

void main()
{
    vec3 n = normalize( vNormal );
    vec3 eye = normalize( vFromEye );
    // the point on the ball is n itself: its radius is 1 and its centre the origin
    vec3 inside = refract( eye, n, 1. / uIndex );
    vec3 exit = n - 2. * dot( n, inside ) * inside;
    vec3 outside = refract( inside, -normalize( exit ), uIndex );
    vec3 through = texture( uAround, outside ).rgb;
    vec3 mirrored = texture( uAround, reflect( eye, n ) ).rgb;
    float c = clamp( dot( -eye, n ), 0., 1. );
    float f = ( uIndex - 1. ) * ( uIndex - 1. ) / ( ( uIndex + 1. ) * ( uIndex + 1. ) );
    float k = uMirror ? f + ( 1. - f ) * pow( 1. - c, 5. ) : 0.;
    gl_FragColor = vec4( ( 1. - k ) * through + k * mirrored, 1. );
}
