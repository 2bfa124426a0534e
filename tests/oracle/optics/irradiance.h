// Light that a surface gathers from all around.
#pragma once

#include <functional>

#include <glm/glm.hpp>

namespace snell::optics {

// Linear radiance that comes from a direction of unit length.
using Radiance = std::function<glm::dvec3(const glm::dvec3& direction)>;

// Solid angle of the texel (column, row) of a cube face of size × size texels, in steradians: differences of
// atan(xy / √(x² + y² + 1)) at its corners, so that they sum to 4π / 6 exactly. A face's middle texel covers up to
// 5.196 times what its corner does; taking them as equal is wrong by 45 % in a room with a bright window.
double texel_solid_angle(int column, int row, int size);

// Irradiance / π (so a uniform environment of radiance 1 gives 1) on a surface with the unit normal, by summing over
// the texels of a cube of size × size a face.
glm::dvec3 irradiance(const Radiance& radiance, const glm::dvec3& normal, int size);

}  // namespace snell::optics
