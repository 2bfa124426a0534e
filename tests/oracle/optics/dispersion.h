// Index of refraction by wavelength.
#pragma once

namespace snell::optics {

// n(λ) = a + b / λ² (Cauchy's first two terms), λ in micrometres.
struct Cauchy {
    double a = 1, b = 0;
    // Wavelength in nanometres; clamped to 300..1100, where the formula means something.
    double index(double nanometres) const;
};

// The glass with index n_d at 587.56 nm (helium d) and Abbe number v_d = (n_d - 1) / (n_F - n_C), with F at 486.13
// and C at 656.27 nm. v_d <= 0 or infinite: no dispersion.
Cauchy cauchy_from_abbe(double n_d, double v_d);

}  // namespace snell::optics
