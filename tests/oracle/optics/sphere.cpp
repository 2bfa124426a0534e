#include "tests/oracle/optics/sphere.h"

#include <algorithm>

namespace snell::optics {

SphereLight through_sphere(const glm::dvec3& incident, const glm::dvec3& normal, double n_outside, double n_inside,
                           int orders) {
    const auto met = meet(incident, normal, n_outside, n_inside);
    if (!met || met->side == Side::inside) return {};
    const glm::dvec3 up = *unit(normal), along = *unit(incident) + met->cos_incident * up;
    const double sin_incident = glm::length(along);
    const glm::dvec3 across = sin_incident > 0.0 ? along / sin_incident : glm::dvec3(0.0);
    const double mean = fresnel(met->cos_incident, n_outside, n_inside);

    SphereLight light;
    light.exits.push_back({0, up, met->reflected, mean});
    if (met->total) return light;

    const double sin_t = sin_incident * (n_outside / n_inside), cos_t = met->cos_transmitted;
    // By the angle π - 2 θt.
    const double turn_cos = (sin_t - cos_t) * (sin_t + cos_t), turn_sin = 2.0 * sin_t * cos_t;
    double c = 1.0, s = 0.0;  // of the exit point's angle from the entry
    double energy = (1.0 - mean) * (1.0 - mean);
    light.inside = 1.0 - mean;
    for (int order = 1; order <= std::min(orders, series_limit) && light.inside >= series_end; ++order) {
        const double next = c * turn_cos - s * turn_sin;
        s = s * turn_cos + c * turn_sin;
        c = next;
        const glm::dvec3 out = c * up + s * across, ahead = c * across - s * up;
        light.exits.push_back({order, out, *unit(met->cos_incident * out + sin_incident * ahead), energy});
        light.inside *= mean;
        energy *= mean;
    }
    return light;
}

}  // namespace snell::optics
