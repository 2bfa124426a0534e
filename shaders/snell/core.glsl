#ifndef SNELL_CORE_GLSL
#define SNELL_CORE_GLSL
// Vectors and Snell's law, safe for every argument. Include it by #include <snell/core.glsl>.
// All of the library needs 32-bit floats (highp in OpenGL ES). Directions of light point toward the surface;
// n1 is the index of refraction on the light's side, n2 the one beyond.
// Conditions name what must hold, as in `if (x > 0.0) …`: GPUs' compilers take its negation for x <= 0.0, which is false
// for NaN.

const float SNELL_PI = 3.14159265358979;
const float SNELL_EPSILON = 1.1920929e-7;  // of a float: 1 + it is the next number after 1

// v divided by its largest component m, in two steps where 1 / m is so small that GPUs take it for 0. s is 1e-30 above
// 1e30, and else 1: a choice between two constants would cost each vector two calls that hide them from compilers.
vec3 snellByLargest(vec3 v, float m) {
    float s = max(step(m, 1.0e30), 1.0e-30);
    return v * s / (m * s);
}

// Unit length for every v but 0, infinity and NaN, for which it is `fallback`. By the largest component first:
// the sum of squares of 1e30 or 1e-30 is not a float.
vec3 snellNormalize(vec3 v, vec3 fallback) {
    float m = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (m > 0.0 && m < 3.0e38) {
        v = snellByLargest(v, m);
        float l2 = dot(v, v);
        if (l2 > 0.0 && l2 < 4.0) return v * inversesqrt(l2);
    }
    return fallback;
}

// mix() whose ends are exact: with weight 0, b may be infinite (0 times infinity is not a number). t is clamped.
vec3 snellMix(vec3 a, vec3 b, float t) {
    if (t >= 1.0) return b;
    return (t > 0.0) ? mix(a, b, t) : a;
}

// Angle between two directions of unit length, radians. acos of a dot product loses all digits below 1e-4.
float snellAngle(vec3 a, vec3 b) {
    vec3 c = cross(a, b);
    float s = length(c), d = dot(a, b);
    return (s > 0.0 || d != 0.0) ? atan(s, d) : 0.0;
}

// Mirror direction, unit length. I and N may have any length, and N may point to either side.
// No direction in I: -N; none in N: -I.
vec3 snellReflect(vec3 I, vec3 N) {
    vec3 n = snellNormalize(N, vec3(0.0));
    vec3 i = snellNormalize(I, -n);
    return snellNormalize(i - 2.0 * dot(n, i) * n, -i);
}

// cos² of the transmitted angle by the cosine c of the incident one; negative past the critical angle. Exact at
// n1 = n2, where 1 - eta² (1 - c²) cancels. Precondition: n1, n2 positive, their squares finite.
float snellCosTransmitted2(float c, float n1, float n2) {
    return ((n2 - n1) * (n2 + n1) + n1 * n1 * c * c) / (n2 * n2);
}

// The cosine itself, in [0,1]; 0 at the critical angle, -1 past it. c is clamped to [0,1]. Past it by less than
// cos² is rounded still gives 0: else light that entered a slab at a grazing angle would be caught in it.
// -1 too when an index is not positive.
float snellCosTransmitted(float c, float n1, float n2) {
    float k = snellCosTransmitted2(clamp(c, 0.0, 1.0), n1, n2), eta = n1 / n2, eta2 = eta * eta;
    bool passes = all(bvec4(n1 > 0.0, n2 > 0.0, eta2 < 3.0e38, k >= -4.0 * SNELL_EPSILON * eta2));
    return passes ? sqrt(clamp(k, 0.0, 1.0)) : -1.0;
}

// Light in direction I at a surface whose normal N points to the side of index n1; both of any length. Light from
// the other side is met by -N, with n1 and n2 exchanged. T is of unit length and never zero: the refracted
// direction, or past the critical angle the mirrored one. False: total reflection, an index that is not positive,
// or a vector without direction. At the critical angle: true, and T runs along the surface.
bool snellRefract(vec3 I, vec3 N, float n1, float n2, out vec3 T) {
    vec3 n = snellNormalize(N, vec3(0.0)), i = snellNormalize(I, vec3(0.0));
    float d = dot(n, i);
    if (d > 0.0) {
        n = -n;
        d = -d;
        float t = n1;
        n1 = n2;
        n2 = t;
    }
    vec3 mirrored = snellReflect(I, N);
    T = mirrored;
    float c = snellCosTransmitted(-d, n1, n2);
    if (c < 0.0 || i == vec3(0.0) || n == vec3(0.0)) {
        T = snellNormalize(mirrored, vec3(0.0, 0.0, -1.0));
        return false;
    }
    // Along the surface, and into it: (i - d n) has no part along n to be rounded.
    T = snellNormalize((n1 / n2) * (i - d * n) - c * n, mirrored);
    return true;
}
#endif
