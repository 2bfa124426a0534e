// Cube map and wall lookup as OpenGL does it, in double precision on 8-bit texels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/glm.hpp>

namespace snell::optics {

// Faces in OpenGL's order: 0..5 = +X -X +Y -Y +Z -Z.
struct CubePoint {
    int face = 0;
    double s = 0.5, t = 0.5;  // in [0,1]; t = 0 is the first row uploaded, which is the image's top row
};

// OpenGL 4.6 core, table 8.19: the component of largest magnitude names the face; ties go to x before y before z
// (GL leaves them open: the faces meet there). Any length but zero; nullopt: zero or not finite.
std::optional<CubePoint> cube_point(const glm::dvec3& direction);
// The inverse: a point of the cube of half side 1, so the largest component is ±1 when s and t lie in [0,1].
glm::dvec3 cube_direction(const CubePoint& point);

// Rows top first, tightly packed; `channels` >= 3, of which the first three are read. Not owned.
struct Texels {
    int width = 0, height = 0, channels = 3;
    std::span<const std::uint8_t> bytes;
    // Row 0 is the top. Precondition: inside.
    glm::dvec3 at(int column, int row) const;
};
using CubeTexels = std::array<Texels, 6>;  // square, of one size

// Bilinear; colours are the bytes / 255, mixed as they are (linear arithmetic, no sRGB). Beyond an edge the
// neighbouring face's texels count, and at a corner the mean of the three that meet (OpenGL 4.6 core §8.16.1). A
// direction of zero length gives the +Z face's centre, as graphics drivers do.
glm::dvec3 sample_cube(const CubeTexels& faces, const glm::dvec3& direction);

// Bilinear on a 2D texture made from an image whose *bottom* row is at t = 0; clamped at its edges.
glm::dvec3 sample_2d(const Texels& image, double s, double t);

// Where direction meets the walls of a room around the origin, as texture coordinates of the six textured quads
// (QuadYZ, QuadXZ, QuadXY at ±a): same image as the cube face, t up. nullopt as cube_point.
std::optional<CubePoint> wall_point(const glm::dvec3& direction);

}  // namespace snell::optics
