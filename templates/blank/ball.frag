#version 330 compatibility

uniform vec3 uColor;
uniform float uKa, uKd;

in vec3 vNormal;

const vec3 TO_LAMP = vec3( .48, .6, .64 );      // a direction of length 1, in eye coordinates

// Runs once for each pixel of the ball.
void main()
{
    // Between two vertices the interpolated normal is shorter than 1.
    vec3 N = normalize( vNormal );

    // The cosine of the angle at which the light arrives; below 0 it arrives from behind.
    float diffuse = max( dot( N, TO_LAMP ), 0. );

    gl_FragColor = vec4( ( uKa + uKd * diffuse ) * uColor, 1. );
}
