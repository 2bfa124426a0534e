#ifndef ROOM_GLSL
#define ROOM_GLSL
// The colour seen in the room of ../environments, whose walls are 5 units from its middle. The ladder LOCALITY:
// infinite: the cube map by direction alone. A ball of radius 1 in the middle has an error of 6.5 degrees on average.
// impostor: with a second cube map, of distances. Its error is .002 degrees after two steps, in any convex room.
// box: the walls are known to be a box. Exact, and as cheap as infinite.
#include <snell/environment.glsl>

uniform samplerCube uRoom;

#ifdef LOCALITY_impostor    // not every scene has this rung
#if LOCALITY == LOCALITY_impostor
#define BY_DISTANCES
uniform samplerCube uDistances;     // in tenths of a unit, to fit into eight bits
#endif
#endif

vec3 room( vec3 from, vec3 direction )
{
#if LOCALITY == LOCALITY_infinite
    vec3 look = snellInfiniteDirection( direction );
#elif defined( BY_DISTANCES )
    vec3 look = snellImpostorDirection( uDistances, from * .1, direction, 2 );
#else
    vec3 look = snellBoxDirection( from, direction, vec3( 5. ), vec3( 0. ) );
#endif
    return texture( uRoom, look ).rgb;
}
#endif
