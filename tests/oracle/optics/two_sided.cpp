#include "tests/oracle/optics/two_sided.h"

#include <algorithm>
#include <cmath>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {

std::optional<glm::dvec3> refract_two_sided(const glm::dvec3& point, const glm::dvec3& incident,
                                            const glm::dvec3& normal, double n_outside, double n_inside, double inner,
                                            const BackFaces& backs) {
    const auto met = meet(incident, normal, n_outside, n_inside);
    if (!met) return std::nullopt;
    const glm::dvec3 inside = met->transmitted;
    const auto straight = met->total ? std::nullopt : backs(point);
    if (!straight) return inside;
    const double across = glm::length(straight->position - point), bent = std::acos(met->cos_incident);
    const double weight = bent > 1e-8 ? std::acos(met->cos_transmitted) / bent : n_outside / n_inside;
    const auto back = backs(point + std::lerp(inner, across, weight) * inside);
    const auto facing = back ? unit(back->normal) : std::nullopt;
    if (!facing) return inside;
    const double c = std::clamp(glm::dot(inside, *facing), 0.0, 1.0);
    const double k = std::max(transmitted_cos2(c, n_inside, n_outside), 0.0);
    return unit(n_inside / n_outside * (inside - c * *facing) + std::sqrt(k) * *facing);
}

}  // namespace snell::optics
