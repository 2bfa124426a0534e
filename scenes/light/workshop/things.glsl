#include <snell/environment.glsl>
#include <snell/fresnel.glsl>
#include "../materials.glsl"

const int PEDESTAL = 0, SATELLITE = 1;
const float HALF_ROOM = 5., SHELL = 1.9;    // the satellite's distance from the middle

// Centre and radius, for a turn from 0 to 1.
vec4 satellite( float turn )
{
    float angle = 6.2831853 * turn + .9;
    return vec4( SHELL * normalize( vec3( sin( angle ), .28 * cos( angle ), cos( angle ) ) ), .33 );
}
