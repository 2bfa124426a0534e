#include "tests/oracle/optics/dispersion.h"

#include <algorithm>
#include <cmath>

namespace snell::optics {
namespace {

constexpr double wavelength_d = 587.56, wavelength_f = 486.13, wavelength_c = 656.27;  // nm, Fraunhofer's lines

double inverse_square(double nanometres) { return 1e6 / (nanometres * nanometres); }  // 1 / µm²

}  // namespace

double Cauchy::index(double nanometres) const { return a + b * inverse_square(std::clamp(nanometres, 300.0, 1100.0)); }

Cauchy cauchy_from_abbe(double n_d, double v_d) {
    if (!(v_d > 0.0) || !std::isfinite(v_d)) return {n_d, 0.0};
    const double b = (n_d - 1.0) / v_d / (inverse_square(wavelength_f) - inverse_square(wavelength_c));
    return {n_d - b * inverse_square(wavelength_d), b};
}

}  // namespace snell::optics
