// A ball of glass as a mesh, one method after the other. P, N and the ray I are interpolated; only functions whose
// comment says so normalise them first.
#include "room.glsl"
#include <snell/refraction.glsl>

const float GLASS = 1.5;

// Ramires: eta .66, Schlick's shape with power 2.
vec3 glassSchlick2(samplerCube room, vec3 N, vec3 I) {
    vec3 n = normalize(N), e = normalize(I);
    const float eta = .66, power = 2.;
    float f = (1. - eta) * (1. - eta) / ((1. + eta) * (1. + eta));
    float schlick = f + (1. - f) * pow(1. - dot(-e, n), power);
    return mix(mapInfinite(room, refract(e, n, eta)), mapInfinite(room, reflect(e, n)), schlick);
}

// Dykhta, with the weights of the listing: ratios .8 and .8 +- .05, cosine to the power 1.55.
vec3 glassOffsets(samplerCube room, vec3 N, vec3 I) {
    vec3 n = normalize(N), v = normalize(I);
    vec3 refracted = vec3(mapInfinite(room, refract(v, n, .85)).r, mapInfinite(room, refract(v, n, .8)).g,
                          mapInfinite(room, refract(v, n, .75)).b);
    float c = pow(clamp(-dot(n, v), 0., 1.), 1.55);
    return mix(mapInfinite(room, reflect(v, n)), refracted, c);
}

// Bailey: the vectors are not normalised.
vec3 glassMixed(samplerCube room, vec3 N, vec3 I, float eta, float mirrored) {
    vec3 reflected = mapInfinite(room, reflect(I, N));
    vec3 T = refract(I, N, eta);
    vec3 refracted = all(equal(T, vec3(0.))) ? reflected : mapInfinite(room, T);
    return mix(refracted, reflected, mirrored);
}

// The same physics in steps: exact reflectance; with `exits`, the light leaves the ball on its other side; with
// `box`, the room has a finite size.
vec3 glassExact(samplerCube room, vec3 P, vec3 N, vec3 I, bool exits, bool box) {
    vec3 n = normalize(N), d = normalize(I);
    float f = snellFresnelExact(-dot(d, n), 1., GLASS);
    vec3 mirrored = snellReflect(d, n), T;
    snellRefract(d, n, 1., GLASS, T);
    vec3 from = exits ? P - 2. * dot(P, T) * T : P;
    vec3 onward = exits ? snellRefractSphere(d, n, 1., GLASS) : T;
    vec3 reflected = box ? mapBox(room, P, mirrored) : mapInfinite(room, mirrored);
    vec3 refracted = box ? mapBox(room, from, onward) : mapInfinite(room, onward);
    return mix(refracted, reflected, f);
}
