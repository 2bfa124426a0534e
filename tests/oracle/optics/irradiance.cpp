#include "tests/oracle/optics/irradiance.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "tests/oracle/optics/cube.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

const double pi = std::acos(-1.0);

template <class Use>
void each_texel(int size, Use use) {
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) {
                const CubePoint point{face, (column + 0.5) / size, (row + 0.5) / size};
                use(*unit(cube_direction(point)), texel_solid_angle(column, row, size));
            }
}

}  // namespace

double texel_solid_angle(int column, int row, int size) {
    const auto corner = [size](int x, int y) {
        const double u = 2.0 * x / size - 1.0, v = 2.0 * y / size - 1.0;
        return std::atan2(u * v, std::sqrt(u * u + v * v + 1.0));
    };
    return corner(column + 1, row + 1) - corner(column, row + 1) - corner(column + 1, row) + corner(column, row);
}

std::array<double, 9> harmonics(const glm::dvec3& d) {
    const double c1 = std::sqrt(3.0 / (4.0 * pi)), c2 = std::sqrt(15.0 / (4.0 * pi));
    return {std::sqrt(1.0 / (4.0 * pi)),
            c1 * d.y,
            c1 * d.z,
            c1 * d.x,
            c2 * d.x * d.y,
            c2 * d.y * d.z,
            std::sqrt(5.0 / (16.0 * pi)) * (3.0 * d.z * d.z - 1.0),
            c2 * d.x * d.z,
            0.5 * c2 * (d.x - d.y) * (d.x + d.y)};
}

Harmonics9 project(const Radiance& radiance, int size) {
    Harmonics9 sum{};
    each_texel(size, [&](const glm::dvec3& d, double solid_angle) {
        const glm::dvec3 light = radiance(d) * solid_angle;
        const auto y = harmonics(d);
        for (std::size_t i = 0; i < 9; ++i) sum[i] += y[i] * light;
    });
    return sum;
}

glm::dvec3 irradiance(const Harmonics9& coefficients, const glm::dvec3& normal, int order) {
    constexpr std::array<double, 9> weight = {1.0, 2.0 / 3, 2.0 / 3, 2.0 / 3, 0.25, 0.25, 0.25, 0.25, 0.25};
    const std::size_t count = order <= 0 ? 1 : order == 1 ? 4 : 9;
    const auto y = harmonics(normal);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < count; ++i) sum += weight[i] * y[i] * coefficients[i];
    return glm::max(sum, glm::dvec3(0.0));
}

glm::dvec3 irradiance(const Radiance& radiance, const glm::dvec3& normal, int size) {
    glm::dvec3 sum(0.0);
    each_texel(size, [&](const glm::dvec3& d, double solid_angle) {
        const double cosine = glm::dot(d, normal);
        if (cosine > 0.0) sum += radiance(d) * (cosine * solid_angle / pi);
    });
    return sum;
}

}  // namespace snell::optics
