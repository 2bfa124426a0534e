#version 330

uniform samplerCube uSurroundings;
uniform vec3 uMetal;
uniform float uPolish;

in vec3 vNormal;
in vec3 vFromEye;

out vec4 outColor;

const vec3 TO_SUN = vec3( -.50, .62, -.60 );

void main()
{
    vec3 N = normalize( vNormal );
    vec3 I = normalize( vFromEye );

    vec3 mirrored = texture( uSurroundings, reflect( I, N ) ).rgb;

    // Polished metal keeps its colour when seen straight on and turns white toward the edge.
    float away = 1. - clamp( -dot( I, N ), 0., 1. );
    float toEdge = away * away * away * away * away;
    vec3 metal = mirrored * mix( uMetal, vec3( 1. ), toEdge );

    float sun = max( dot( N, normalize( TO_SUN ) ), 0. );
    vec3 paint = uMetal * ( .25 + .75 * sun );

    outColor = vec4( mix( paint, metal, uPolish ), 1. );
}
