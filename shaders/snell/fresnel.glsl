#ifndef SNELL_FRESNEL_GLSL
#define SNELL_FRESNEL_GLSL
#include <snell/core.glsl>
// How much light a surface reflects: the rungs of the ladder, cheapest first. `c` is the cosine of the angle of
// incidence, clamped to [0,1] by every function: dot products of unit vectors exceed 1. All results are in [0,1].
// Errors: mean over a ball's disc / largest, for n = 1.52 from outside.

// (1 - c)^5 by multiplication: pow() is slower than exact Fresnel, and undefined for a negative base.
float snellPow5(float x) {
    float x2 = x * x;
    return x2 * x2 * x;
}

// At normal incidence: ((n1 - n2) / (n1 + n2))². An index that is not positive or not finite: 1. As a rung:
// .052 / .957.
float snellFresnelF0(float n1, float n2) {
    float r = (n1 - n2) / (n1 + n2);
    return (n1 > 0.0 && n2 > 0.0 && n1 + n2 < 8.0e37) ? min(r * r, 1.0) : 1.0;
}

// 1 - c, "opacity". .242 / .489. No index: the same on both sides, no critical angle.
float snellFresnelOneMinusCos(float c) { return 1.0 - clamp(c, 0.0, 1.0); }

// Schlick's shape with power 2 instead of 5. .107 / .315. From outside only.
float snellFresnelSchlick2(float c, float f0) {
    float m = 1.0 - clamp(c, 0.0, 1.0);
    return f0 + (1.0 - f0) * (m * m);
}

// The Cg Tutorial's clamp(bias + scale (1 - c)^power). .476 / .869 for .3, 2, 2; .0049 / .104 for .048, .848, 4.55,
// fitted to n = 1.52. The power is clamped to [.001, 64]; at c = 1 the result is the bias. From outside only.
float snellFresnelCg(float c, float bias, float scale, float power) {
    float m = 1.0 - clamp(c, 0.0, 1.0), p = (power > 0.001) ? min(power, 64.0) : 0.001;
    float shape = (m > 0.0) ? pow(m, p) : 0.0;
    float f = bias + scale * shape;
    return (f > 0.0) ? min(f, 1.0) : 0.0;
}

// Schlick 1994 for a given f0. .0090 / .0345. From outside only: from inside use snellFresnelSchlick.
float snellFresnelSchlick5(float c, float f0) { return f0 + (1.0 - f0) * snellPow5(1.0 - clamp(c, 0.0, 1.0)); }

// Schlick 1994 for both sides: from the denser side by the cosine of the transmitted angle (.0039 mean; by the
// incident one .52), 1 at and past the critical angle. Equal indices: 0, unlike Schlick's formula, whose grazing
// value would be 1.
float snellFresnelSchlick(float c, float n1, float n2) {
    if (n1 == n2 && n1 > 0.0) return 0.0;
    float beyond = (n1 > n2) ? snellCosTransmitted(c, n1, n2) : clamp(c, 0.0, 1.0);
    return (beyond >= 0.0) ? snellFresnelSchlick5(beyond, snellFresnelF0(n1, n2)) : 1.0;
}

// Schlick with a spherical Gaussian for the power (Karis 2013). .0077 / .038. Both sides, as snellFresnelSchlick.
float snellFresnelGaussian(float c, float n1, float n2) {
    if (n1 == n2 && n1 > 0.0) return 0.0;
    float beyond = (n1 > n2) ? snellCosTransmitted(c, n1, n2) : clamp(c, 0.0, 1.0);
    float f0 = snellFresnelF0(n1, n2);
    return (beyond >= 0.0) ? f0 + (1.0 - f0) * min(exp2((-5.55473 * beyond - 6.98316) * beyond), 1.0) : 1.0;
}

// Exact, per polarisation: x perpendicular to, y in the plane of incidence. Both sides; 1 at and past the critical
// angle, at grazing, and for an index that is not positive; 0 for equal indices. The difference of squares
// (n1 - n2)(n1 + n2) keeps n = 1.0003 exact, where the textbook's difference of products loses half its digits.
vec2 snellFresnelPolarised(float c, float n1, float n2) {
    c = clamp(c, 0.0, 1.0);
    if (n1 == n2 && n1 > 0.0) return vec2(0.0);
    float k = snellCosTransmitted2(c, n1, n2), t = sqrt(clamp(k, 0.0, 1.0)), d = n1 * c + n2 * t;
    // A cosine is at most 1, but for roundings: otherwise squares of the indices left the range of floats.
    if (n1 > 0.0 && n2 > 0.0 && k > 0.0 && k < 2.0 && d > 0.0) {
        float rs = (n1 - n2) / d * ((n1 + n2) / d), p = c * t, q = n1 / n2 * (1.0 - c) * (1.0 + c);
        float s = p + q, r = (s > 0.0) ? (p - q) / s : 0.0;
        float s2 = clamp(rs * rs, 0.0, 1.0);
        return vec2(s2, s2 * min(r * r, 1.0));
    }
    return vec2(1.0);
}

// Exact for unpolarised light: the reference.
float snellFresnelExact(float c, float n1, float n2) {
    vec2 f = snellFresnelPolarised(c, n1, n2);
    return 0.5 * (f.x + f.y);
}

// The ladder of metals: snellFresnelSchlick5 with the metal's f0, largest error .006 (silver) to .20 (chromium); this,
// .001 to .024; snellFresnelConductor. Schlick's shape less a c (1 - c)^6, a dip before grazing (Lazanyi and
// Szirmay-Kalos 2005). `a` by snellFresnelLazanyiDepth.
float snellFresnelLazanyi(float c, float f0, float a) {
    c = clamp(c, 0.0, 1.0);
    float m = 1.0 - c, f = snellFresnelSchlick5(c, f0) - a * c * (m * snellPow5(m));
    return (f > 0.0) ? min(f, 1.0) : 0.0;
}

// Exact for a metal of index eta + i k, from a medium of index n1, unpolarised. Quotients of sums of squares, which
// can't leave [0,1]. No critical angle while k > 0; k = 0 is a dielectric. Not positive n1, or eta = k = 0: 1.
// Precondition: eta and k at least 0 and below 1e8.
float snellFresnelConductor(float c, float n1, float eta, float k) {
    c = clamp(c, 0.0, 1.0);
    float n = eta / n1, m = k / n1, sin2 = (1.0 - c) * (1.0 + c);
    float real = (n - m) * (n + m) - sin2, product = n * m, w = max(abs(real), 2.0 * product);
    bool physical = n1 > 0.0 && n >= 0.0 && m >= 0.0 && n + m > 0.0 && n + m < 1.0e9 && w > 0.0;
    float x = real / w, y = 2.0 * product / w, modulus = w * sqrt(x * x + y * y);
    float larger = sqrt(0.5 * (modulus + abs(real))), smaller = product / larger;
    float a = (real >= 0.0) ? larger : smaller, b = (real >= 0.0) ? smaller : larger;
    // Divided by the size of a + i b, so that no square leaves the range of floats.
    float size = max(larger, 1.0);
    vec2 up = vec2(c - a, b) / size, down = vec2(c + a, b) / size;
    float below = dot(down, down), rs = (below > 0.0) ? dot(up, up) / below : 1.0;
    up = vec2(a * c - sin2, b * c) / size;
    down = vec2(a * c + sin2, b * c) / size;
    below = dot(down, down);
    float rp = rs * ((below > 0.0) ? dot(up, up) / below : 1.0);
    return physical ? clamp(0.5 * (rs + rp), 0.0, 1.0) : 1.0;
}

// The `a` with which snellFresnelLazanyi is exact at c = 1/7, where c (1 - c)^6 is greatest. The same for all of a
// surface: compute it once, in the vertex shader or by hand (aluminium 1.7, chromium 3.4).
float snellFresnelLazanyiDepth(float n1, float eta, float k) {
    float c = 1.0 / 7.0, m = 1.0 - c, f0 = snellFresnelConductor(1.0, n1, eta, k);
    return (snellFresnelSchlick5(c, f0) - snellFresnelConductor(c, n1, eta, k)) / (c * (m * snellPow5(m)));
}
#endif
