#include "tests/oracle/optics/locality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell::optics {

glm::dvec3 box_direction(const glm::dvec3& point, const glm::dvec3& direction, const Room& room) {
    const glm::dvec3 p = glm::clamp(point - room.centre, -room.half * 0.9999, room.half * 0.9999);
    double nearest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double d = direction[axis];
        if (d != 0.0) nearest = std::min(nearest, (std::copysign(room.half[axis], d) - p[axis]) / d);
    }
    return std::isfinite(nearest) ? p + nearest * direction : direction;
}

glm::dvec3 impostor_direction(const glm::dvec3& point, const glm::dvec3& direction, int iterations,
                              const std::function<double(const glm::dvec3&)>& distance) {
    double d = distance(direction);
    for (int i = 0; i < std::clamp(iterations, 0, 8); ++i) {
        const glm::dvec3 hit = point + d * direction;
        const double length = glm::length(hit);
        if (!(length > 0.0)) break;
        d = std::max(d + distance(hit / length) - length, 0.0);
    }
    return point + d * direction;
}

double wall_distance(const glm::dvec3& direction, const glm::dvec3& half) {
    const glm::dvec3 a = glm::abs(direction) / half;
    return 1.0 / std::max({a.x, a.y, a.z});
}

}  // namespace snell::optics
