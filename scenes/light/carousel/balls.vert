#version 330

#include "orbit.glsl"

uniform mat4 PVM;
uniform float Timer;

in vec4 position;
in vec4 aColor;     // red: the number of the ball

out vec3 vNormal;
flat out int vBall;

void main()
{
    vBall = int( aColor.r + .5 );
    vec4 ball = orbit( vBall, Timer );
    vNormal = position.xyz;
    gl_Position = PVM * vec4( ball.xyz + ball.w * position.xyz, 1. );
}
