// The room's light. Each wall has its own colour, brighter toward its bottom, with waves of a few degrees as seen
// from the middle: directions with a larger error see something unrelated. Colours and waves were fitted
// to an earlier measurement of the methods' errors (docs/accuracy.md).
#include <snell/environment.glsl>

const vec3 ROOM_SIZE = vec3(5.);
const float MAP_SCALE = .5;  // scale of the light in the cube map, whose 8 bits end at 1
const vec3 WAVES = vec3(12., 13., 14.);  // half-waves along a wall

vec3 wallColor(int wall) {
    if (wall == 0) return vec3(.271, .558, .160);
    if (wall == 1) return vec3(.075, .096, .552);
    if (wall == 2) return vec3(.299, .205, .285);
    if (wall == 3) return vec3(.020, .803, .020);
    if (wall == 4) return vec3(.840, .999, .027);
    return vec3(.359, .802, .597);
}

// An approximation of sin(pi x) by parabolas.
vec3 hump(vec3 x) {
    vec3 f = fract(x);
    return 4. * f * (1. - f) * (1. - 2. * mod(floor(x), 2.));
}

// The light seen from P along d. Each colour has its own wave.
vec3 roomAlong(vec3 P, vec3 d) {
    vec2 st;
    int wall = snellWall(P, d, ROOM_SIZE, vec3(0.), st);
    vec3 wave = hump(WAVES * st.s) * hump(WAVES * st.t);
    return wallColor(wall) * (1. + .474 * wave - .484 * (2. * st.t - 1.));
}

// The same from a cube map taken in the middle: by direction alone, and corrected for P.
vec3 mapInfinite(samplerCube room, vec3 d) { return texture(room, d).rgb / MAP_SCALE; }
vec3 mapBox(samplerCube room, vec3 P, vec3 d) {
    return texture(room, snellBoxDirection(P, d, ROOM_SIZE, vec3(0.))).rgb / MAP_SCALE;
}
