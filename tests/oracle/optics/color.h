// From wavelengths to the colours of a screen.
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace snell::optics {

// CIE 1931 2° matching functions x̄ ȳ z̄, as the multi-lobe fit of Wyman, Sloan and Shirley (JCGT 2(2), 2013), whose
// error is below the spread between human observers. All but zero outside 380..780 nm; NaN gives zero.
glm::dvec3 cie_1931(double nanometres);

// IEC 61966-2-1: primaries of sRGB, white D65, linear. Not clamped: spectral colours lie outside.
glm::dvec3 xyz_to_linear_srgb(const glm::dvec3& xyz);

// One wavelength that stands for its neighbours, and how much it counts in red, green and blue.
struct Band {
    double nanometres = 0;
    glm::dvec3 rgb{0};
};
// `count` bands of equal width over 380..780 nm: the matching functions' integral over the band, at its centroid under
// x̄ + ȳ + z̄. The weights of each channel sum to 1, so that a uniform white environment stays white: without it, 4 bands
// make it magenta. Precondition: count >= 1; with fewer than three bands some channel may have weights of both signs
// that nearly cancel.
std::vector<Band> spectral_bands(int count);

// The three wavelengths that stand for red, green and blue where there are only three: 611, 549, 464 nm.
inline constexpr glm::dvec3 rgb_wavelengths{611.0, 549.0, 464.0};

}  // namespace snell::optics
