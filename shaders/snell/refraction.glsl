#ifndef SNELL_REFRACTION_GLSL
#define SNELL_REFRACTION_GLSL
#include <snell/fresnel.glsl>
// Light through glass: the rungs of the ladder, cheapest first. I is the direction of the eye ray toward the
// surface, N the outward normal; both of any length. n1 is the index outside, n2 the one of the glass.

// One interface. For a ball of n = 1.5 the direction is 18 degrees wrong in the mean, 48 at the rim. Past the
// critical angle the mirrored direction.
vec3 snellRefractSingle(vec3 I, vec3 N, float n1, float n2) {
    vec3 T;
    snellRefract(I, N, n1, n2, T);
    return T;
}

// Both interfaces of a ball, exact: 2 (T·I) T - I, by the symmetry of the chord. No second refraction, so no false
// total reflection at the rim. Past the critical angle (n2 < n1) and for light from inside: the mirrored direction.
vec3 snellRefractSphere(vec3 I, vec3 N, float n1, float n2) {
    vec3 T;
    vec3 i = snellNormalize(I, vec3(0.0, 0.0, -1.0));
    if (dot(i, N) > 0.0 || !snellRefract(i, N, n1, n2, T)) return snellReflect(i, N);
    return snellNormalize(2.0 * dot(T, i) * T - i, T);
}

// What pictures of an object's back show of its normals: N in eye space, any length.
vec3 snellBackNormal(vec3 N) { return 0.5 + 0.5 * snellNormalize(N, vec3(0.0, 0.0, 1.0)); }

// Of a point in eye space: -z as a fraction of `range`, spread over three channels so that 8 bits each are enough.
// Not to be filtered. Nothing there: 0.
vec3 snellBackDepth(vec3 P, float range) {
    float x = clamp(-P.z / range, 0.0, 0.999999);
    vec3 digits = fract(x * vec3(1.0, 255.0, 65025.0));
    return vec3(digits.xy - digits.yz / 255.0, digits.z);
}

// The depth at a place of the picture, from 0 to 1 across; 0: nothing is there.
float snellBackDepthAt(sampler2D backDepths, vec2 st, float range) {
    ivec2 size = textureSize(backDepths, 0), at = ivec2(floor(st * vec2(size)));
    if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size))) return 0.0;
    return dot(texelFetch(backDepths, at, 0).rgb, vec3(1.0, 1.0 / 255.0, 1.0 / 65025.0)) * range;
}

// Both sides of any object, by what is seen of its back (Wyman 2005). For a ball of n = 1.5 and a distant eye less
// than 1 degree wrong up to .6 of its radius; near the rim it fails. Light that would be totally reflected at the back
// runs along it: mostly the back's normal is to blame.
// P: where the eye ray meets the front; I: its direction; N: outward normal; in eye space. inner: the distance
// through the object from P against N, a property of the mesh (of a ball: its diameter). projection: clip from eye.
// backs: pictures, as large as the screen, of the object's back faces (CullFace front); of their normals as
// snellBackNormal, and of their depths as snellBackDepth with this range. Where they show nothing: as
// snellRefractSingle.
vec3 snellRefractTwoSided(vec3 P, vec3 I, vec3 N, float n1, float n2, float inner, mat4 projection,
                          sampler2D backNormals, sampler2D backDepths, float range) {
    vec3 T, i = snellNormalize(I, vec3(0.0, 0.0, -1.0)), n = snellNormalize(N, -i);
    if (!snellRefract(i, n, n1, n2, T)) return T;
    vec4 seen = projection * vec4(P, 1.0);
    float depth = snellBackDepthAt(backDepths, 0.5 + 0.5 * seen.xy / seen.w, range);
    // The chord is between the way straight through, where light is not bent, and the way along the normal.
    float across = max((depth + P.z) / -i.z, 0.0), bent = snellAngle(-i, n);
    float w = (bent > 1.0e-4) ? snellAngle(T, -n) / bent : n1 / n2;
    seen = projection * vec4(P + mix(inner, across, w) * T, 1.0);
    vec2 st = 0.5 + 0.5 * seen.xy / seen.w;
    bool seenBack = depth > 0.0 && abs(i.z) > 1.0e-6 && snellBackDepthAt(backDepths, st, range) > 0.0;
    vec3 back = snellNormalize(textureLod(backNormals, st, 0.0).xyz * 2.0 - 1.0, T);
    float c = clamp(dot(T, back), 0.0, 1.0);
    vec3 twice = snellNormalize((n2 / n1) * (T - c * back) + max(snellCosTransmitted(c, n2, n1), 0.0) * back, T);
    return seenBack ? twice : T;
}

// All ways out of a ball, one after the other. Use:
//     SnellSphere s = snellSphereBegin(I, N, n1, n2);
//     color = s.energy * look(s.direction);                         // mirrored outside
//     for (int order = 1; order <= orders && snellSphereNext(s); ++order) color += s.energy * look(s.direction);
// The path lies in a plane and each chord turns it by the same angle, so that exit k is exit 1 turned k - 1 times.
struct SnellSphere {
    vec3 direction;  // unit length, away from the ball
    vec3 normal;     // unit vector from the centre to where it leaves
    float energy;    // share of the light
    float inside;    // share that is still in the ball after this exit
    vec3 up, across;
    vec2 angle, turn;  // cosine and sine
    float cosI, sinI, reflectance;
    int order;
};

const int SNELL_ORDERS = 32;       // at most, whatever is asked for
const float SNELL_SERIES_END = 1.0e-4;  // less than this inside ends the series

// Order 0, the mirrored ray. Light from the inside, past the critical angle, or with an index that is not positive:
// energy 1, and no further exits.
SnellSphere snellSphereBegin(vec3 I, vec3 N, float n1, float n2) {
    SnellSphere s;
    s.up = snellNormalize(N, vec3(0.0, 0.0, 1.0));
    vec3 i = snellNormalize(I, -s.up);
    float d = dot(i, s.up);
    s.cosI = clamp(-d, 0.0, 1.0);
    vec3 along = i - d * s.up;
    s.sinI = min(length(along), 1.0);
    s.across = snellNormalize(along, vec3(0.0));
    s.reflectance = (d <= 0.0) ? snellFresnelExact(s.cosI, n1, n2) : 1.0;
    float c = snellCosTransmitted(s.cosI, n1, n2);
    float t = (c > 0.0) ? min(s.sinI * (n1 / n2), 1.0) : 0.0;
    s.turn = vec2((t - c) * (t + c), 2.0 * t * c);
    s.angle = vec2(1.0, 0.0);
    s.direction = snellReflect(i, s.up);
    s.normal = s.up;
    bool enters = c > 0.0 && s.reflectance < 1.0;
    s.energy = enters ? s.reflectance : 1.0;
    s.inside = enters ? 1.0 - s.reflectance : 0.0;
    s.order = 0;
    return s;
}

// The next exit. False, and s unchanged: too little is left inside, or the limit is reached.
bool snellSphereNext(inout SnellSphere s) {
    if (s.inside < SNELL_SERIES_END || s.order >= SNELL_ORDERS) return false;
    s.angle = vec2(s.angle.x * s.turn.x - s.angle.y * s.turn.y, s.angle.y * s.turn.x + s.angle.x * s.turn.y);
    s.normal = s.angle.x * s.up + s.angle.y * s.across;
    vec3 ahead = s.angle.x * s.across - s.angle.y * s.up;
    s.direction = snellNormalize(s.cosI * s.normal + s.sinI * ahead, s.normal);
    s.energy = s.inside * (1.0 - s.reflectance);
    s.inside *= s.reflectance;
    s.order += 1;
    return true;
}
#endif
