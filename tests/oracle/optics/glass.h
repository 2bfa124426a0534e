// What things are made of: index of refraction by wavelength, from the literature.
#pragma once

#include <span>
#include <string_view>

namespace snell::optics {

// A transparent material. The formulas are fits (Sellmeier's, Cauchy's, or the author's own) that have poles outside
// their range: wavelengths are clamped to it, so that every wavelength has a finite index.
struct Glass {
    std::string_view name;                                   // "BK7"
    std::string_view source;                                 // who measured it
    double shortest = 380, longest = 780;                    // nm, where the fit holds
    double (*formula)(double square_micrometres) = nullptr;  // n by λ²

    // `nanometres` in vacuum or air (they differ by .03 %, less than the last digit here). NaN: the index at the d
    // line.
    double index(double nanometres) const;
    double index_d() const { return index(587.56); }  // the number in tables
    // (n_d - 1) / (n_F - n_C): about 60 for crown glass, 25 for dense flint; small means strong dispersion.
    double abbe() const;
};

// Air, ice, water, Pyrex, window glass, quartz, BK7, SF11, cubic zirconia, diamond, moissanite; by rising index_d
// but for the two optical glasses.
// By name, letter for letter; null: there is none.
const Glass* find_glass(std::string_view name);

// A metal's complex index eta + i k.
struct Complex {
    double eta = 1, k = 0;
};
struct Metal {
    std::string_view name, source;
    std::span<const double, 26> values;  // eta and k in turn, from 397.4 to 756 nm
    // Linear between the measurements, clamped to their range; NaN: as for 587.56 nm.
    Complex index(double nanometres) const;
};
// Gold, silver, copper, aluminium, chromium.
std::span<const Metal> metals();

}  // namespace snell::optics
