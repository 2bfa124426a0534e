// Light that a surface gathers from all around: directly, and by spherical harmonics.
#pragma once

#include <array>
#include <functional>

#include <glm/glm.hpp>

namespace snell::optics {

// Linear radiance that comes from a direction of unit length.
using Radiance = std::function<glm::dvec3(const glm::dvec3& direction)>;

// Solid angle of the texel (column, row) of a cube face of size × size texels, in steradians: differences of
// atan(xy / √(x² + y² + 1)) at its corners, so that they sum to 4π / 6 exactly. A face's middle texel covers up to
// 5.196 times what its corner does; taking them as equal is wrong by 45 % in a room with a bright window.
double texel_solid_angle(int column, int row, int size);

// The nine real harmonics of orders 0 to 2 at a unit direction, in the order
// 1, y, z, x, xy, yz, 3z² - 1, xz, x² - y² (Ramamoorthi and Hanrahan 2001, with their constants).
std::array<double, 9> harmonics(const glm::dvec3& direction);

// Coefficients of radiance in that order.
using Harmonics9 = std::array<glm::dvec3, 9>;
// By the centres of a cube's texels, size × size a face, each with its own solid angle; summed in double.
Harmonics9 project(const Radiance& radiance, int size);

// Irradiance / π (so a uniform environment of radiance 1 gives 1) on a surface with the unit normal, from the
// harmonics up to `order` (0, 1 or 2) weighted by 1, 2/3, 1/4. Not windowed: that is right for radiance, and makes
// irradiance worse. Negative values, which a strong small light leaves on the far side, become 0.
glm::dvec3 irradiance(const Harmonics9& coefficients, const glm::dvec3& normal, int order = 2);

// The same by summing over a cube's texels: the reference.
glm::dvec3 irradiance(const Radiance& radiance, const glm::dvec3& normal, int size);

}  // namespace snell::optics
