#ifndef SNELL_NOISE_GLSL
#define SNELL_NOISE_GLSL
// Noise without textures: the same numbers on every GPU, as integers make them.

// Three independent 32-bit hashes of three integers (pcg3d: Jarzynski and Olano, JCGT 9(3), 2020).
uvec3 snellHash(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v ^= v >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

// One of the twelve edges' directions of a cube (Perlin 2002), times the offset from the corner.
float snellNoiseCorner(ivec3 cell, vec3 offset) {
    uint edge = snellHash(uvec3(cell)).x >> 28u;
    float u = edge < 8u ? offset.x : offset.y;
    float v = edge < 4u ? offset.y : (edge == 12u || edge == 14u ? offset.x : offset.z);
    return ((edge & 1u) == 0u ? u : -u) + ((edge & 2u) == 0u ? v : -v);
}

// Gradient noise in [-1,1], 0 at integer points, twice differentiable, without a period below 2^32.
// 0 where p has a component beyond 8388608 (there floats have no fractions), or NaN.
float snellNoise(vec3 p) {
    bool fractions = all(lessThan(abs(p), vec3(8388608.0)));
    vec3 low = floor(p), f = p - low;
    ivec3 c = ivec3(low);
    vec3 w = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec4 near = vec4(snellNoiseCorner(c, f), snellNoiseCorner(c + ivec3(1, 0, 0), f - vec3(1.0, 0.0, 0.0)),
                     snellNoiseCorner(c + ivec3(0, 1, 0), f - vec3(0.0, 1.0, 0.0)),
                     snellNoiseCorner(c + ivec3(1, 1, 0), f - vec3(1.0, 1.0, 0.0)));
    vec4 far = vec4(snellNoiseCorner(c + ivec3(0, 0, 1), f - vec3(0.0, 0.0, 1.0)),
                    snellNoiseCorner(c + ivec3(1, 0, 1), f - vec3(1.0, 0.0, 1.0)),
                    snellNoiseCorner(c + ivec3(0, 1, 1), f - vec3(0.0, 1.0, 1.0)),
                    snellNoiseCorner(c + ivec3(1, 1, 1), f - vec3(1.0, 1.0, 1.0)));
    vec4 z = mix(near, far, w.z);
    vec2 y = mix(z.xy, z.zw, w.y);
    return fractions ? clamp(mix(y.x, y.y, w.x), -1.0, 1.0) : 0.0;
}

// Octaves of it, each of half the size and half the weight, scaled to [-1,1]. `octaves` is clamped to 1..8.
float snellFractalNoise(vec3 p, int octaves) {
    float sum = 0.0, weight = 1.0, total = 0.0;
    for (int i = 0; i < 8; ++i) {
        if (i > 0 && i >= octaves) break;
        sum += weight * snellNoise(p);
        total += weight;
        weight *= 0.5;
        p = 2.0 * p + 17.0;
    }
    return sum / total;
}
#endif
