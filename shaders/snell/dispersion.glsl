#ifndef SNELL_DISPERSION_GLSL
#define SNELL_DISPERSION_GLSL
#include <snell/refraction.glsl>
#include <snell/bands.glsl>
// Glass that bends blue more than red. Its index is Cauchy's a + b / w², w in micrometres: BK7 1.5046, .0042;
// SF11 1.7384, .0160; diamond 2.3786, .0134. With b = 0 every function below looks once.

// Wavelength in nanometres, clamped to 300..1100, where the formula means something.
float snellCauchy(float a, float b, float nanometres) {
    float w = clamp(nanometres, 300.0, 1100.0) * 0.001;
    return a + b / (w * w);
}

// Sellmeier's n² = 1 + b1 w² / (w² - c1) + … for glasses whose data sheets have it, where two terms of Cauchy's are
// .01 off in the violet (SF11). Wavelength as above, but not below 370: the poles lie there. At least 1.
float snellSellmeier(vec3 b, vec3 c, float nanometres) {
    float w = clamp(nanometres, 370.0, 1100.0) * 0.001, w2 = w * w;
    vec3 terms = b * w2 / (w2 - c);
    float n2 = 1.0 + terms.x + terms.y + terms.z;
    return (n2 > 1.0) ? sqrt(n2) : 1.0;
}

// The indices at 611, 549 and 464 nm: the three wavelengths that stand best for red, green and blue.
vec3 snellCauchyRgb(float a, float b) {
    return vec3(snellCauchy(a, b, 611.0), snellCauchy(a, b, 549.0), snellCauchy(a, b, 464.0));
}

// Through a surface (one interface) or a ball (both), with an index for each channel: what is seen in the infinitely
// far environment. No reflectance is multiplied in. A channel past the critical angle sees the mirrored direction.
vec3 snellDisperseSurfaceRgb(samplerCube environment, vec3 I, vec3 N, float n1, vec3 n2) {
    vec3 g = texture(environment, snellRefractSingle(I, N, n1, n2.g)).rgb;
    if (n2.r == n2.g && n2.g == n2.b) return g;
    return vec3(texture(environment, snellRefractSingle(I, N, n1, n2.r)).r, g.g,
                texture(environment, snellRefractSingle(I, N, n1, n2.b)).b);
}
vec3 snellDisperseSphereRgb(samplerCube environment, vec3 I, vec3 N, float n1, vec3 n2) {
    vec3 g = texture(environment, snellRefractSphere(I, N, n1, n2.g)).rgb;
    if (n2.r == n2.g && n2.g == n2.b) return g;
    return vec3(texture(environment, snellRefractSphere(I, N, n1, n2.r)).r, g.g,
                texture(environment, snellRefractSphere(I, N, n1, n2.b)).b);
}

// The same by `count` wavelengths (4, 6, 8, 16, 32 or 64; others are rounded up, beyond 64 down), each weighted by
// what its band adds to red, green and blue: a grey environment stays grey, and single channels may be a little below
// 0, as spectral colours lie outside of what a screen has. Time grows with count.
vec3 snellDisperseSphere(samplerCube environment, vec3 I, vec3 N, float n1, float a, float b, int count) {
    if (b == 0.0) return texture(environment, snellRefractSphere(I, N, n1, a)).rgb;
    int first = snellBandFirst(count), last = first + snellBandCount(count);
    vec3 sum = vec3(0.0);
    for (int i = first; i < last; ++i) {
        vec4 band = SNELL_BANDS[i];
        vec3 d = snellRefractSphere(I, N, n1, snellCauchy(a, b, band.w));
        sum += band.rgb * texture(environment, d).rgb;
    }
    return sum;
}
#endif
