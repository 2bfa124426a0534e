#version 330 compatibility

uniform float uHeight, uRows, uEdge, uLampX, uLampY;
uniform vec3 uBrick, uMortar;

in vec2 vAt;
in vec3 vPosition;

const float JOINT = .06;        // half the width of a joint, in heights of a brick

// 1 on a brick, 0 in the joints, smooth in between. Any other height can take its place.
float height( vec2 at )
{
    vec2 p = .5 * uRows * at;               // a brick is 1 high
    float row = floor( p.y );
    p.x += mod( row, 2. );                  // every second row is moved by half a brick, which is 2 wide

    // The distances from the nearest ends of the brick.
    vec2 inside = vec2( 1. - abs( mod( p.x, 2. ) - 1. ), .5 - abs( p.y - row - .5 ) );
    vec2 up = smoothstep( JOINT, JOINT + uEdge, inside );
    return up.x * up.y;
}

void main()
{
    // The slopes of the height along x and y, by differences between points that are near each other.
    const float STEP = .001;
    float h = height( vAt );
    vec2 slope = uHeight / STEP * ( vec2( height( vAt + vec2( STEP, 0. ) ), height( vAt + vec2( 0., STEP ) ) ) - h );

    // Of a height z(x,y), ( -dz/dx, -dz/dy, 1 ) is normal to the surface.
    vec3 N = normalize( gl_NormalMatrix * vec3( -slope, 1. ) );
    vec3 L = normalize( vec3( uLampX, uLampY, -1.2 ) - vPosition );     // from the surface to the lamp
    vec3 E = normalize( -vPosition );           // from the surface to the eye, which is the origin
    vec3 H = normalize( L + E );                // a mirror with this normal would show the lamp

    vec3 color = mix( uMortar, uBrick, smoothstep( 0., .3, h ) );
    float diffuse = max( dot( N, L ), 0. );
    float shine = pow( max( dot( N, H ), 0. ), 30. );
    gl_FragColor = vec4( ( .25 + .75 * diffuse ) * color + .15 * shine, 1. );
}
