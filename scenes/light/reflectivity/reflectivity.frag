#version 330

#include "../room.glsl"
#include "../show.glsl"

layout(location = 0) out vec4 o_color;

in vec3 v_position, v_normal, v_fromEye, v_reflected;
in vec2 v_st;

uniform sampler2D uMap;
uniform float uReflectivity;
uniform vec3 uClay, uGold;
uniform int uView;

void main(void)
{
    vec3 N = normalize( v_normal );
#if WHERE == WHERE_vertex
    vec3 reflected = v_reflected;
#else
    vec3 reflected = reflect( normalize( v_fromEye ), N );
#endif

    float share = uReflectivity;
#if MAP == MAP_on
    share *= texture( uMap, v_st ).r;
#endif

    float lit = .25 + .75 * max( dot( N, normalize( vec3( .2, .75, .6 ) ) ), 0. );
    vec3 color = mix( lit * uClay, uGold * room( v_position, reflected ), share );
    if( uView == 1 )
        color = showDirection( reflected );
    if( uView == 2 )
        color = showShare( share );
    o_color = vec4( color, 1. );
}
