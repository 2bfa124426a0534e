#version 330 compatibility

in vec3 vDirection;

// White stripes from pole to pole, and a ring, all without colour.
void main()
{
    vec3 d = normalize( vDirection );
    float around = atan( d.x, -d.z ), wide = max( length( d.xz ), .02 );
    float edge = .004 / wide;
    float stripe = fract( around * 16. / 6.2831853 );
    float white = smoothstep( .5 - 2. * edge, .5 + 2. * edge, stripe ) * smoothstep( 1., 1. - 4. * edge, stripe );
    float ring = smoothstep( .30, .31, abs( d.y ) ) * smoothstep( .42, .41, abs( d.y ) );
    white = mix( white, 1. - white, ring );
    gl_FragColor = vec4( vec3( .03 + .94 * white ), 1. );
}
