// Refraction at both sides of an object by what a picture shows of its back: the oracle of snellRefractTwoSided.
#pragma once

#include <functional>
#include <optional>

#include <glm/glm.hpp>

namespace snell::optics {

struct BackFace {
    glm::dvec3 position{0}, normal{0};  // normal: outward, of any length but zero
};
// What the picture of back faces shows where a point appears in it. nullopt: nothing.
using BackFaces = std::function<std::optional<BackFace>(const glm::dvec3& point)>;

// Wyman 2005: the chord inside is the mean of the distance straight through, to the back that the picture shows at
// the point itself, and of `inner`, the one against the normal, weighted by θt/θi and the rest. Where the chord ends
// in the picture the back's normal is looked up and refracts again; light that would be totally reflected there runs
// along the surface instead, for mostly the normal is wrong. Exact in the middle of a ball, .9 degrees wrong at .6 of
// its radius, and useless at the rim. Vectors of any length; `normal` faces the ray. Returns a unit vector; as after
// one refraction where the picture shows nothing. nullopt: as meet().
std::optional<glm::dvec3> refract_two_sided(const glm::dvec3& point, const glm::dvec3& incident,
                                            const glm::dvec3& normal, double n_outside, double n_inside, double inner,
                                            const BackFaces& backs);

}  // namespace snell::optics
