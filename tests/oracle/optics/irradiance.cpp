#include "tests/oracle/optics/irradiance.h"

#include <cmath>
#include <numbers>

#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
double texel_solid_angle(int column, int row, int size) {
    const auto corner = [size](int x, int y) {
        const double u = 2.0 * x / size - 1.0, v = 2.0 * y / size - 1.0;
        return std::atan2(u * v, std::sqrt(u * u + v * v + 1.0));
    };
    return corner(column + 1, row + 1) - corner(column, row + 1) - corner(column + 1, row) + corner(column, row);
}

glm::dvec3 irradiance(const Radiance& radiance, const glm::dvec3& normal, int size) {
    glm::dvec3 sum(0.0);
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const glm::dvec3 d = *unit(cube_direction({face, (column + 0.5) / size, (row + 0.5) / size}));
                const double cosine = glm::dot(d, normal);
                if (cosine > 0.0) sum += radiance(d) * (cosine * texel_solid_angle(column, row, size));
            }
    return sum / std::numbers::pi;
}

}  // namespace snell::optics
