#include "../show.glsl"

uniform samplerCube uEnvironment;
uniform vec3 uBaseColor;
uniform float uMixRatio;
uniform int uView;

varying vec3 vIncident, vNormal, vReflected;
varying float vLit;

void main()
{
#if WHERE == WHERE_vertex
    vec3 reflected = vReflected;
#else
    vec3 reflected = reflect( normalize( vIncident ), normalize( vNormal ) );
#endif
    vec3 mirrored = textureCube( uEnvironment, reflected ).rgb;
    vec3 paint = ( .15 + .85 * vLit ) * uBaseColor;

    vec3 color = mix( mirrored, paint, uMixRatio );
    if( uView == 1 )
        color = showDirection( reflected );
    if( uView == 2 )
        color = showShare( vLit );
    gl_FragColor = vec4( color, 1. );
}
