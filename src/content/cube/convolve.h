// Convolutions of cube maps: irradiance for diffuse surfaces, prefiltered levels for rough mirrors, and spherical
// harmonics. No GL.
#pragma once

#include <array>
#include <vector>

#include "src/content/cube/cubemap.h"

namespace snell::content {

// Linear radiance on the six faces of a cube: three floats per texel, top row first, faces in OpenGL's order.
struct CubeLight {
    int size = 0;
    std::vector<std::array<float, 3>> texels;  // 6 · size · size

    const std::array<float, 3>& at(int face, int column, int row) const;
};

// Converts faces to radiance. Values are taken as they are (bytes / 255), because that is what shaders read. The faces
// must have one size and format, as load_cube returns them. Values that are not finite count as 0.
CubeLight cube_light(const CubeFaces& faces);
// Converts to half floats with alpha 1, clamped to ±65504.
CubeFaces half_faces(const CubeLight& light);

// Solid angle, in steradians, of the part s0..s1, t0..t1 (within 0..1) of a face: differences of atan(xy / √(x² + y² +
// 1)) at its corners. Whole faces sum to 4π exactly.
double solid_angle(double s0, double t0, double s1, double t1);

// Resamples to another size. Every texel is the mean of what it covers, weighted by solid angle, so the light from all
// directions together is preserved. Enlarging repeats texels. Sums are in double.
CubeLight resized(const CubeLight& light, int size);

// The nine coefficients of radiance of orders 0 to 2, in the order 1, y, z, x, xy, yz, 3z² - 1, xz, x² - y²
// (Ramamoorthi and Hanrahan 2001). They are weighted by the texels' solid angles, in double, and not windowed, which is
// right for irradiance.
using Harmonics = std::array<std::array<float, 3>, 9>;
Harmonics harmonics(const CubeLight& light);

// Irradiance / π by the direction of the normal, so that uniform light of 1 gives 1. The integral is a sum over 16
// texels per side, each with the mean direction of its light; its error is below .5 % of the mean. A result of 16
// texels per side, read with seamless filtering, adds an error of .1 %.
CubeLight irradiance(const CubeLight& light, int size = 16);

// Radiance for mirrors of increasing roughness, by the direction of reflection. Level 0 is the source resized to `size`
// (a power of two, at least 16); each further level has half the size, and the last has 8. Level l belongs to the
// roughness l / (levels - 1). The lobe is GGX's with alpha = roughness², for a viewer along the normal (Karis 2013: "N
// = V = R"), so at roughness 1 it equals irradiance. The integral covers all of the source, with coarser steps where
// the lobe is flatter; the result differs from a sum over every texel by less than 1 %.
std::vector<CubeLight> prefiltered(const CubeLight& light, int size);
// The number of levels of prefiltered() for a level 0 of that size.
int prefilter_levels(int size);
// The default size of level 0: the source's, rounded to a power of two, from 16 to `largest`.
int prefilter_size(int source_size, int largest);

}  // namespace snell::content
