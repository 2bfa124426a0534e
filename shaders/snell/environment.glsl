#ifndef SNELL_ENVIRONMENT_GLSL
#define SNELL_ENVIRONMENT_GLSL
#include <snell/core.glsl>
// Which way to look into an environment: the rungs of locality. P and d are in the space of the cube map (the
// world's); eye-space vectors are wrong by the camera's rotation. A ball of radius 1 in a room of half size 5 is seen
// 6.5 degrees wrong in the mean by the infinite map; by the impostor .70, .034, .003 for 0, 1, 2 iterations; by box
// projection exactly.
// For refraction, leave the glass first: box projection from the point of entry makes it worse.

// Infinitely far: the direction, with its largest component 1, as squares of 1e30 or 1e-30 are no floats on the way
// to the texel. 0, infinity or NaN: +Z.
vec3 snellInfiniteDirection(vec3 d) {
    float m = max(max(abs(d.x), abs(d.y)), abs(d.z));
    vec3 scaled = snellByLargest(d, m);
    float length2 = dot(scaled, scaled);  // 1 to 3, unless a component is no number
    return (m < 3.0e38 && length2 > 0.0 && length2 < 4.0) ? scaled : vec3(0.0, 0.0, 1.0);
}

// A room with walls at centre ± halfSize, seen from its centre by the cube map (Lagarde and Zanuttini 2012): the
// point of the wall that is met, relative to the centre. P on or beyond a wall is first moved just inside (to .9999
// of the half size). A component of d below 1e-20 of the largest meets no wall; d = 0 or not finite looks along +Z.
// Preconditions: P finite, halfSize positive.
vec3 snellBoxDirection(vec3 P, vec3 direction, vec3 halfSize, vec3 centre) {
    vec3 d = snellInfiniteDirection(direction), a = abs(d);
    vec3 p = clamp(P - centre, -halfSize * 0.9999, halfSize * 0.9999);
    float t = 3.0e38;
    if (a.x > 1.0e-20) t = min(t, ((d.x > 0.0 ? halfSize.x : -halfSize.x) - p.x) / d.x);
    if (a.y > 1.0e-20) t = min(t, ((d.y > 0.0 ? halfSize.y : -halfSize.y) - p.y) / d.y);
    if (a.z > 1.0e-20) t = min(t, ((d.z > 0.0 ? halfSize.z : -halfSize.z) - p.z) / d.z);
    return t < 3.0e38 ? p + t * d : d;
}

// The walls themselves as six pictures: which one the ray from P meets, in the order +X -X +Y -Y +Z -Z, and where, as
// the texture coordinates of QuadYZ, QuadXZ and QuadXY. Preconditions as above.
int snellWall(vec3 P, vec3 d, vec3 halfSize, vec3 centre, out vec2 st) {
    vec3 h = snellBoxDirection(P, d, halfSize, centre) / halfSize, a = abs(h);
    if (a.x >= a.y && a.x >= a.z) {
        st = a.x > 0.0 ? vec2(h.x > 0.0 ? -h.z : h.z, h.y) / a.x : vec2(0.0);
        st = 0.5 * st + 0.5;
        return h.x > 0.0 ? 0 : 1;
    }
    if (a.y >= a.z) {
        st = 0.5 * vec2(h.x, h.y > 0.0 ? -h.z : h.z) / a.y + 0.5;
        return h.y > 0.0 ? 2 : 3;
    }
    st = 0.5 * vec2(h.z > 0.0 ? h.x : -h.x, h.y) / a.z + 0.5;
    return h.z > 0.0 ? 4 : 5;
}

// An environment whose distance in each direction is known, as seen from the origin (Szirmay-Kalos and others 2005):
// `distances` has it in red. P relative to the map's centre, d of unit length; `iterations` is clamped to 0..8.
// Converges in convex surroundings, with no proof beyond; never looks backward.
vec3 snellImpostorDirection(samplerCube distances, vec3 P, vec3 d, int iterations) {
    float t = textureLod(distances, d, 0.0).r;
    for (int i = 0; i < 8; ++i) {
        if (i >= iterations) break;
        vec3 hit = P + t * d;
        t = max(t + textureLod(distances, snellInfiniteDirection(hit), 0.0).r - length(hit), 0.0);
    }
    return P + t * d;
}

// What a mirror of some roughness sees in a cube map that 'Prefilter' made: r the direction of reflection, roughness
// 0 (the surroundings themselves) to 1 (what a matt surface gathers). Level l of the chain, whose last has 8 texels a
// side, is for the roughness l / (levels - 1). Exact for a viewer along the normal; at grazing angles a real lobe is
// longer and this one is not. Multiply by the reflectance.
vec3 snellPrefiltered(samplerCube prefiltered, vec3 r, float roughness) {
    float last = 0.0;
    for (int size = textureSize(prefiltered, 0).x; size > 8; size /= 2) last += 1.0;
    float level = roughness > 0.0 ? min(roughness, 1.0) * last : 0.0;
    return textureLod(prefiltered, snellInfiniteDirection(r), level).rgb;
}
#endif
