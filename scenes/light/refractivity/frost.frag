#version 330 compatibility

in vec2 vST;

// Clear bands around the ball, and a clear window on each side.
void main()
{
    float winding = fract( 6. * vST.s + 5. * vST.t );
    float clear = smoothstep( .48, .52, winding ) * smoothstep( 1., .96, winding );
    vec2 window = vec2( fract( 4. * vST.s ) - .5, 2.2 * ( vST.t - .5 ) );
    clear = max( clear, smoothstep( .36, .34, length( window ) ) );
    gl_FragColor = vec4( vec3( clear ), 1. );
}
