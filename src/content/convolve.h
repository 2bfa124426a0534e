// Light gathered from a cube map: by matt surfaces, by rough mirrors, as spherical harmonics. No GL.
#pragma once

#include <array>
#include <vector>

#include "src/content/cubemap.h"

namespace snell::content {

// Linear radiance on the six faces of a cube, three floats a texel, rows top first, faces in OpenGL's order.
struct CubeLight {
    int size = 0;
    std::vector<std::array<float, 3>> texels;  // 6 · size · size

    const std::array<float, 3>& at(int face, int column, int row) const;
};

// Values as they are (bytes / 255): what a picture holds is what its shaders see. Faces alike, as load_cube gives
// them. What is not finite counts as 0.
CubeLight cube_light(const CubeFaces& faces);
// Half floats with alpha 1, clamped to ±65504.
CubeFaces half_faces(const CubeLight& light);

// Solid angle of the part of a face that s0..s1, t0..t1 (0..1) cut out, in steradians: differences of
// atan(xy / √(x² + y² + 1)) at its corners. Whole faces sum to 4π exactly.
double solid_angle(double s0, double t0, double s1, double t1);

// Every texel is the mean of what it covers, by solid angle: the light from all around stays what it was, whatever
// the sizes. Enlarging repeats texels. Sums in double.
CubeLight resized(const CubeLight& light, int size);

// By solid angle, in double.
std::array<double, 3> mean_radiance(const CubeLight& light);

// The nine coefficients of radiance of orders 0 to 2, in the order 1, y, z, x, xy, yz, 3z² - 1, xz, x² - y²
// (Ramamoorthi and Hanrahan 2001), by the texels' solid angles, in double; not windowed, which is right for
// irradiance.
using Harmonics = std::array<std::array<float, 3>, 9>;
Harmonics harmonics(const CubeLight& light);

// Irradiance / π by the normal, so that uniform light of 1 gives 1. The integral is a sum over 16 texels a side, each
// taken where the light in it comes from: within .5 % of the mean. Looked up with seamless filtering 16 texels a side
// are good for .1 %.
CubeLight irradiance(const CubeLight& light, int size = 16);

// What mirrors of growing roughness see, by the direction of reflection: level 0 is the source resized to `size` (a
// power of two, at least 16), the others have half the size of the one before, the last 8. Level l is for the
// roughness l / (levels - 1); the lobe is GGX's with alpha = roughness², for a viewer along the normal (Karis 2013:
// "N = V = R"), so at roughness 1 it is irradiance. Integrated over all of the source, coarser where the lobe is
// flatter: within 1 % of summing over every texel.
std::vector<CubeLight> prefiltered(const CubeLight& light, int size);
int prefilter_levels(int size);
// The size of level 0 where none is given: the source's, made a power of two, from 16 to `largest`.
int prefilter_size(int source_size, int largest);

// The weight of light at the cosine c from the reflected direction, not normalised: c / (1 - (1 - α²)(1 + c)/2)² for
// c > 0. GGX's D(h)·(n·l) with n·h = √((1 + c)/2).
double lobe_weight(double cosine, double alpha);

}  // namespace snell::content
