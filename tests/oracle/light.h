// Light of cube maps by other ways than the product's.
#pragma once

#include <array>
#include <numbers>

#include "src/content/cube/convolve.h"
#include "tests/oracle/optics/irradiance.h"

namespace snell::content {

// Mean over all directions: texels weighted by their exact solid angles.
inline std::array<double, 3> mean_radiance(const CubeLight& light) {
    std::array<double, 3> sum{};
    const int size = light.size;
    for (int i = 0; i < 6 * size * size; ++i) {
        const double angle = optics::texel_solid_angle(i % size, i / size % size, size) / (4 * std::numbers::pi);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += angle * static_cast<double>(light.texels[static_cast<std::size_t>(i)][c]);
    }
    return sum;
}

// The weight, not normalised, of light at the cosine c from the reflected direction: c / (1 - (1 - α²)(1 + c)/2)² for
// c > 0. This is GGX's D(h)·(n·l) with n·h = √((1 + c)/2).
inline double lobe_weight(double cosine, double alpha) {
    if (cosine <= 0) return 0;
    const double spread = alpha * alpha + (1 - alpha * alpha) * (1 - cosine) / 2;
    return cosine / (spread * spread);
}

}  // namespace snell::content
