#version 330

#include "things.glsl"

uniform mat4 PVM;
uniform mat4 M;
uniform mat4 uModelViewerMatrix;
uniform float Timer;

in vec4 position;
in vec4 normal;
in vec4 aColor;

out vec3 vPosition, vNormal, vFromEye;
flat out int vThing;

void main()
{
    vThing = int( aColor.r + .5 );
    vec4 place = vThing == SATELLITE ? satellite( Timer ) : vec4( 0., 0., 0., 1. );
    vec4 own = vec4( place.xyz + place.w * position.xyz, 1. );
    vPosition = vec3( M * own );
    vNormal = vec3( M * normal );
    vFromEye = vec3( uModelViewerMatrix * own );
    gl_Position = PVM * own;
}
