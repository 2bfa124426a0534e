#include "tests/oracle/optics/glass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "tests/oracle/optics/dispersion.h"

namespace snell::optics {
namespace {

constexpr double line_d = 587.56, line_f = 486.13, line_c = 656.27;  // nm, Fraunhofer's

// Sellmeier: n² = 1 + Σ b λ² / (λ² - c), λ in µm.
struct Term {
    double b, c;
};
template <std::size_t Count>
double sellmeier(double l2, const Term (&terms)[Count], double constant = 0.0) {
    double n2 = 1.0 + constant;
    for (const Term& term : terms) n2 += term.b * l2 / (l2 - term.c);
    return std::sqrt(n2);
}
constexpr double squared(double x) { return x * x; }

double air(double l2) { return 1.0 + 0.05792105 / (238.0185 - 1.0 / l2) + 0.00167917 / (57.362 - 1.0 / l2); }
// Cauchy's two terms through the tabulated 1.3194 at 400 and 1.3069 at 700 nm; within 4e-4 of the table between.
double ice(double l2) { return 1.300838 + 0.0029699 / l2; }
double water(double l2) {
    return sellmeier(l2, {{0.5684027565, 0.005101829712},
                          {0.1726177391, 0.01821153936},
                          {0.02086189578, 0.02620722293},
                          {0.1130748688, 10.69792721}});
}
double pyrex(double l2) { return cauchy_from_abbe(1.4714, 65.4).index(1e3 * std::sqrt(l2)); }
double window(double l2) { return 1.5130 - 0.003169 * l2 + 0.003962 / l2; }
double quartz(double l2) { return sellmeier(l2, {{1.07044083, 0.0100585997}, {1.10202242, 100.0}}, 0.28604141); }
double bk7(double l2) {
    return sellmeier(l2, {{1.03961212, 0.00600069867}, {0.231792344, 0.0200179144}, {1.01046945, 103.560653}});
}
double sf11(double l2) {
    return sellmeier(l2, {{1.73759695, 0.013188707}, {0.313747346, 0.0623068142}, {1.89878101, 155.23629}});
}
double zirconia(double l2) {
    return sellmeier(l2,
                     {{1.347091, squared(0.062543)}, {2.117788, squared(0.166739)}, {9.452943, squared(24.320570)}});
}
double diamond(double l2) { return sellmeier(l2, {{0.3306, squared(0.175)}, {4.3356, squared(0.106)}}); }
double moissanite(double l2) { return std::sqrt(6.7452 + 0.15352 / (l2 - 0.03597) - 0.02249 * l2); }

constexpr std::array<Glass, 11> table = {{
    {"air", "Ciddor 1996, dry, 15 °C, 101.325 kPa", 230, 1690, air},
    {"ice", "Warren and Brandt 2008, table, -7 °C", 380, 780, ice},
    {"water", "Daimon and Masumura 2007, 20 °C", 200, 1100, water},
    {"Pyrex", "borosilicate glass 3.3, Schott Borofloat 33 data sheet: n_d 1.4714, v_d 65.4", 380, 780, pyrex},
    {"window glass", "Rubin 1985, clear soda-lime", 310, 4600, window},
    {"quartz", "Ghosh 1999, crystal, ordinary ray", 198, 2050, quartz},
    {"BK7", "Schott catalogue 2017, N-BK7", 300, 2500, bk7},
    {"SF11", "Schott catalogue 2017, N-SF11", 370, 2500, sf11},
    {"cubic zirconia", "Wood and Nassau 1982, 12 mol% yttria", 361, 5135, zirconia},
    {"diamond", "Peter 1923", 225, 1000, diamond},
    {"moissanite", "Wang and others 2013, 6H silicon carbide, extraordinary ray", 380, 2325, moissanite},
}};

constexpr std::array<double, 13> wavelengths = {397.4, 413.3, 430.5, 450.9, 471.4, 495.9, 520.9,
                                                548.6, 582.1, 616.8, 659.5, 704.5, 756.0};
// eta and k of each wavelength in turn.
using Row = std::array<double, 26>;
constexpr Row gold = {1.47,  1.952, 1.46,  1.958, 1.45,  1.948, 1.38,  1.914, 1.31,  1.849, 1.04,  1.833, 0.62,
                      2.081, 0.43,  2.455, 0.29,  2.863, 0.21,  3.272, 0.14,  3.697, 0.13,  4.103, 0.14,  4.542};
constexpr Row silver = {0.05,  2.070, 0.05,  2.275, 0.04,  2.462, 0.04,  2.657, 0.05,  2.869, 0.05,  3.093, 0.05,
                        3.324, 0.06,  3.586, 0.05,  3.858, 0.06,  4.152, 0.05,  4.483, 0.04,  4.838, 0.03,  5.242};
constexpr Row copper = {1.32,  2.116, 1.28,  2.207, 1.25,  2.305, 1.24,  2.397, 1.25,  2.483, 1.22,  2.564, 1.18,
                        2.608, 1.02,  2.577, 0.70,  2.704, 0.30,  3.205, 0.22,  3.747, 0.21,  4.205, 0.24,  4.665};
// Interpolated to these wavelengths from the author's own, which lie 30 to 45 nm apart.
constexpr Row aluminium = {0.481, 4.803, 0.521, 5.001, 0.572, 5.215, 0.636, 5.465, 0.709, 5.712, 0.798, 6.0,   0.892,
                           6.291, 1.009, 6.611, 1.169, 6.988, 1.35,  7.371, 1.624, 7.8,   1.958, 8.175, 2.427, 8.435};
constexpr Row chromium = {2.00, 2.83, 2.08, 2.93, 2.19, 3.04, 2.33, 3.14, 2.51, 3.24, 2.75, 3.30, 2.94,
                          3.33, 3.18, 3.33, 3.22, 3.30, 3.17, 3.30, 3.09, 3.34, 3.05, 3.39, 3.08, 3.42};
constexpr std::string_view johnson = "Johnson and Christy 1972";
constexpr std::array<Metal, 5> metal_table = {{{"gold", johnson, gold},
                                               {"silver", johnson, silver},
                                               {"copper", johnson, copper},
                                               {"aluminium", "Rakic 1995", aluminium},
                                               {"chromium", "Johnson and Christy 1974", chromium}}};

}  // namespace

double Glass::index(double nanometres) const {
    const double nm = std::isnan(nanometres) ? line_d : std::clamp(nanometres, shortest, longest);
    return formula(squared(nm * 1e-3));
}

double Glass::abbe() const { return (index(line_d) - 1.0) / (index(line_f) - index(line_c)); }

const Glass* find_glass(std::string_view name) {
    const auto* found = std::ranges::find(table, name, &Glass::name);
    return found == table.end() ? nullptr : found;
}

Complex Metal::index(double nanometres) const {
    const double nm = std::isnan(nanometres) ? line_d : std::clamp(nanometres, wavelengths.front(), wavelengths.back());
    const auto above = std::ranges::upper_bound(wavelengths, nm);
    if (above == wavelengths.end()) return {values[24], values[25]};
    const auto i = static_cast<std::size_t>(above - wavelengths.begin());
    const double t = (nm - wavelengths[i - 1]) / (wavelengths[i] - wavelengths[i - 1]);
    return {std::lerp(values[2 * i - 2], values[2 * i], t), std::lerp(values[2 * i - 1], values[2 * i + 1], t)};
}

std::span<const Metal> metals() { return metal_table; }

}  // namespace snell::optics
