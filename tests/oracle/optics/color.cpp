#include "tests/oracle/optics/color.h"

#include <cmath>

namespace snell::optics {
namespace {

// A Gaussian with one width below its peak and another above.
double lobe(double nm, double height, double peak, double below, double above) {
    const double t = (nm - peak) / (nm < peak ? below : above);
    return height * std::exp(-0.5 * t * t);
}

constexpr double first_nm = 380.0, last_nm = 780.0;

// Of the matching functions over [low, low + width], by the midpoint rule; they are smooth on this scale.
struct Sum {
    glm::dvec3 xyz{0};
    double moment = 0, mass = 0;
};
Sum integrate(double low, double width) {
    const int steps = static_cast<int>(std::ceil(width / 0.25));
    Sum sum;
    for (int i = 0; i < steps; ++i) {
        const double nm = low + (i + 0.5) * width / steps;
        const glm::dvec3 xyz = cie_1931(nm) * (width / steps);
        const double mass = xyz.x + xyz.y + xyz.z;
        sum.xyz += xyz;
        sum.mass += mass;
        sum.moment += mass * nm;
    }
    return sum;
}

}  // namespace

glm::dvec3 cie_1931(double nm) {
    if (std::isnan(nm)) return glm::dvec3(0);
    return {
        lobe(nm, 1.056, 599.8, 37.9, 31.0) + lobe(nm, 0.362, 442.0, 16.0, 26.7) + lobe(nm, -0.065, 501.1, 20.4, 26.2),
        lobe(nm, 0.821, 568.8, 46.9, 40.5) + lobe(nm, 0.286, 530.9, 16.3, 31.1),
        lobe(nm, 1.217, 437.0, 11.8, 36.0) + lobe(nm, 0.681, 459.0, 26.0, 13.8)};
}

glm::dvec3 xyz_to_linear_srgb(const glm::dvec3& c) {
    return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z, -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
            0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

std::vector<Band> spectral_bands(int count) {
    const double width = (last_nm - first_nm) / count;
    std::vector<Band> bands;
    glm::dvec3 total(0);
    for (int i = 0; i < count; ++i) {
        const Sum sum = integrate(first_nm + i * width, width);
        const Band band{sum.moment / sum.mass, xyz_to_linear_srgb(sum.xyz)};
        total += band.rgb;
        bands.push_back(band);
    }
    for (Band& band : bands) band.rgb /= total;
    return bands;
}

}  // namespace snell::optics
