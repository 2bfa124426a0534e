#ifndef SNELL_IRRADIANCE_GLSL
#define SNELL_IRRADIANCE_GLSL
#include <snell/core.glsl>
// Light that a matt surface gathers from all around, divided by pi: a uniform environment of radiance 1 gives 1.

// From nine coefficients of radiance in the order 1, y, z, x, xy, yz, 3z² - 1, xz, x² - y² (Ramamoorthi and Hanrahan
// 2001). Error .3 % under a sky, 4 to 7 % with one small bright light. Negative values become 0.
// n of unit length. `order` 0, 1 or 2: how many of them count (1, 4 or 9).
vec3 snellIrradianceHarmonics(vec3 c[9], vec3 n, int order) {
    vec3 e = 0.282094792 * c[0];
    if (order >= 1) e += 0.325735008 * (c[1] * n.y + c[2] * n.z + c[3] * n.x);
    if (order >= 2)
        e += 0.273137108 * (c[4] * (n.x * n.y) + c[5] * (n.y * n.z) + c[7] * (n.x * n.z)) +
             0.078847891 * (3.0 * n.z * n.z - 1.0) * c[6] + 0.136568554 * ((n.x - n.y) * (n.x + n.y)) * c[8];
    return max(e, vec3(0.0));
}

// The i-th of `count` directions spread over the hemisphere around the unit vector n, as dense as the cosine
// (golden spiral on the disc, lifted). The frame is that of Duff and others 2017: no direction of n is special.
vec3 snellCosineDirection(vec3 n, int i, int count) {
    float r2 = (float(i) + 0.5) / float(count), angle = 2.0 * SNELL_PI * fract(float(i) * 0.618033989);
    float z = sqrt(max(1.0 - r2, 0.0)), r = sqrt(r2);
    float s = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;
    vec3 t = vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), u = vec3(b, s + n.y * n.y * a, -n.y);
    return r * cos(angle) * t + r * sin(angle) * u + z * n;
}

// By `count` lookups (clamped to 1..1024): the reference when there are enough, and the dearest by far.
vec3 snellIrradianceQuadrature(samplerCube environment, vec3 n, int count) {
    int last = clamp(count, 1, 1024);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 1024; ++i) {
        if (i >= last) break;
        sum += textureLod(environment, snellCosineDirection(n, i, last), 0.0).rgb;
    }
    return sum / float(last);
}
#endif
