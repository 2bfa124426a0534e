// Mirror and Snell in double precision: what the GPU's pictures are judged by. No GL, no I/O.
// Directions point along the light's (or the eye ray's) way *toward* the surface; angles are in radians, measured
// from the normal; indices of refraction are relative to vacuum and positive.
#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace snell::optics {

// GLSL's formula, word for word: I - 2 (N·I) N (GLSL 4.60 §8.5). Mirrors only if N has unit length; any other
// length is wrong in the same way as on the GPU, and is here to be compared with.
glm::dvec3 glsl_reflect(const glm::dvec3& incident, const glm::dvec3& normal);

// GLSL's formula, word for word: k = 1 - eta² (1 - (N·I)²); k < 0: the zero vector; else
// eta I - (eta (N·I) + √k) N (GLSL 4.60 §8.5). eta = n_from / n_to. Right only if both vectors have unit length
// and N·I <= 0; other lengths are wrong in the same way as on the GPU.
glm::dvec3 glsl_refract(const glm::dvec3& incident, const glm::dvec3& normal, double eta);

// Length 1 whatever the length was, from 1e-300 to 1e300. nullopt: zero, or not finite.
std::optional<glm::dvec3> unit(const glm::dvec3& v);

// Angle between two directions of any length, by atan2: exact down to 1e-16 rad, where acos of a dot product loses
// everything below 1e-8.
double angle_between(const glm::dvec3& a, const glm::dvec3& b);

// Mirror direction, of unit length. The vectors may have any length; the side of the normal does not matter.
// nullopt: one of them has no direction.
std::optional<glm::dvec3> mirror(const glm::dvec3& incident, const glm::dvec3& normal);

// cos² of the transmitted angle, negative past the critical angle. Snell's law as
// ((n2-n1)(n2+n1) + n1² c²) / n2²: exact at n1 = n2, where 1 - eta² (1 - c²) cancels at grazing incidence.
double transmitted_cos2(double cos_incident, double n1, double n2);

enum class Side { outside, inside };

// What happens to a ray at an interface.
struct Interface {
    Side side = Side::outside;   // where the ray comes from: outside is where the normal points to
    bool total = false;          // total internal reflection: nothing is transmitted
    glm::dvec3 reflected{0};     // unit length
    glm::dvec3 transmitted{0};   // unit length; equal to `reflected` when total
    double cos_incident = 1;     // in [0,1]
    double cos_transmitted = 1;  // in [0,1]; 0 when total
    double n1 = 1, n2 = 1;       // index on the ray's side, and beyond
};

// The vectors may have any length. A ray that comes from the inside is met by the flipped normal and by swapped
// indices. At the critical angle itself the ray runs along the surface (total is false), and so it does beyond it by
// no more than cos² is rounded: else light that came in through one side of a slab at a grazing angle would be
// caught inside.
// nullopt: a vector has no direction, or an index is not finite and positive.
std::optional<Interface> meet(const glm::dvec3& incident, const glm::dvec3& normal, double n_outside, double n_inside);

// Where total reflection begins: asin(n2 / n1). nullopt when n1 <= n2: it never does.
std::optional<double> critical_angle(double n1, double n2);
// Where p-polarised light is not reflected: atan(n2 / n1).
double brewster_angle(double n1, double n2);

// Direction in which a ray leaves a sphere that it entered with direction `incident` and crosses with direction
// `inside`, both of unit length: 2 (T·I) T - I, by the symmetry of the chord. Never a false total reflection.
glm::dvec3 leave_sphere(const glm::dvec3& incident, const glm::dvec3& inside);

}  // namespace snell::optics
