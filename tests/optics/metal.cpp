#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

// Fresnel's amplitudes in complex arithmetic.
Polarised by_complex_numbers(double c, double n1, double eta, double k) {
    const std::complex<double> n2(eta, k), s2 = n1 * n1 * (1 - c * c), t = std::sqrt(n2 * n2 - s2) / n2;
    const auto rs = (n1 * c - n2 * t) / (n1 * c + n2 * t), rp = (n2 * c - n1 * t) / (n2 * c + n1 * t);
    return {std::norm(rs), std::norm(rp)};
}

TEST(Conductor, AgreesWithComplexArithmetic) {
    for (double n1 : {1.0, 1.33, 2.42})
        for (double eta : {0.04, 0.43, 1.0, 1.5, 3.0})
            for (double k : {0.3, 1.9, 4.5, 12.0})
                for (double c = 0; c <= 1; c += 0.01) {
                    const Polarised mine = fresnel_conductor_polarised(c, n1, eta, k);
                    const Polarised truth = by_complex_numbers(c, n1, eta, k);
                    EXPECT_NEAR(mine.s, truth.s, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                    EXPECT_NEAR(mine.p, truth.p, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                }
}

TEST(Conductor, WithoutAbsorptionIsADielectric) {
    for (double n : {1.31, 1.52, 2.42})
        for (double c = 0.001; c <= 1; c += 0.001) {
            EXPECT_NEAR(fresnel_conductor(c, 1, n, 0), fresnel(c, 1, n), 1e-12) << n << " " << c;
            EXPECT_NEAR(fresnel_conductor(c, n, 1, 0), fresnel(c, n, 1), 1e-7) << "from inside " << n << " " << c;
        }
    EXPECT_EQ(fresnel_conductor(0.1, 1.5, 1, 0), 1.0);
}

// Hard case 70 for metals, and 12: at grazing incidence everything is mirrored.
TEST(Conductor, StaysWithinZeroAndOne) {
    for (double eta : {0.0, 1e-6, 0.05, 1.0, 1e6})
        for (double k : {1e-9, 1e-3, 1.0, 5.0, 1e6})
            for (double c : {-1.0, 0.0, 1e-9, 0.3, 1.0, 1.0000004}) {
                const Polarised f = fresnel_conductor_polarised(c, 1, eta, k);
                EXPECT_TRUE(f.s >= 0 && f.s <= 1) << eta << " " << k << " " << c << ": " << f.s;
                EXPECT_TRUE(f.p >= 0 && f.p <= 1) << eta << " " << k << " " << c << ": " << f.p;
                EXPECT_TRUE(c > 0 || f.mean() > 1 - 1e-12) << eta << " " << k;
            }
}

// A smooth gold mirror, from the handbooks: red and yellow are kept, blue is not.
TEST(Conductor, GoldIsGold) {
    const Metal& gold = metals()[0];
    const auto normal = [&](double nm) {
        const Complex n = gold.index(nm);
        return fresnel_conductor(1, 1, n.eta, n.k);
    };
    EXPECT_NEAR(normal(650), 0.96, 0.02);
    EXPECT_NEAR(normal(550), 0.80, 0.02);
    EXPECT_NEAR(normal(450), 0.38, 0.03);
}

TEST(ConductorLadder, SchlickFailsWhereAbsorptionIsStrong) {
    const auto worst = [](double eta, double k) {
        const double f0 = fresnel_conductor(1, 1, eta, k);
        double off = 0;
        for (double c = 0; c <= 1; c += 0.001)
            off = std::max(off, std::abs(schlick(c, f0) - fresnel_conductor(c, 1, eta, k)));
        return off;
    };
    EXPECT_NEAR(worst(0.96, 6.69), 0.091, 0.01);  // aluminium, 550 nm
    EXPECT_LT(worst(0.43, 2.455), 0.01);          // gold, 549 nm
}

// Over a ball's disc, where cosines have the density 2 c: mean and largest distance from the exact reflectance.
struct Off {
    double mean = 0, most = 0;
};
template <class Rung>
Off over_disc(double eta, double k, Rung rung) {
    Off off;
    constexpr int steps = 4000;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps, here = std::abs(rung(c) - fresnel_conductor(c, 1, eta, k));
        off.mean += 2 * c * here / steps;
        off.most = std::max(off.most, here);
    }
    return off;
}
Off of_schlick(double eta, double k) {
    const double f0 = fresnel_conductor(1, 1, eta, k);
    return over_disc(eta, k, [&](double c) { return schlick(c, f0); });
}
Off of_lazanyi(double eta, double k) {
    const double f0 = fresnel_conductor(1, 1, eta, k), a = lazanyi_depth(eta, k);
    return over_disc(eta, k, [&](double c) { return lazanyi(c, f0, a); });
}

// The errors that are known of indices as renderers have them for red, green and blue.
TEST(ConductorLadder, SchlicksErrorsAreTheKnownOnes) {
    struct Known {
        const char* name;
        double eta, k, f0, most, mean;
    };
    for (const Known& m : {Known{"gold, red", 0.143119, 3.98316, 0.967, 0.016, 0.0037},
                           Known{"gold, green", 0.374957, 2.38572, 0.802, 0.0056, 0.0020},
                           Known{"gold, blue", 1.44248, 1.60322, 0.324, 0.029, 0.0117},
                           Known{"silver, red", 0.155265, 4.82835, 0.975, 0.019, 0.0036},
                           Known{"copper, red", 0.200438, 3.91295, 0.952, 0.022, 0.0050},
                           Known{"aluminium, green", 0.96, 6.69, 0.921, 0.091, 0.0139},
                           Known{"chromium, green", 3.18, 3.31, 0.553, 0.197, 0.0298}}) {
        SCOPED_TRACE(m.name);
        EXPECT_NEAR(fresnel_conductor(1, 1, m.eta, m.k), m.f0, 0.002);
        const Off off = of_schlick(m.eta, m.k);
        EXPECT_NEAR(off.most, m.most, 0.1 * m.most);
        EXPECT_NEAR(off.mean, m.mean, 0.1 * m.mean);
    }
}

// With the indices of the table: what the pages on light say.
TEST(ConductorLadder, MeasuredMetals) {
    struct Row {
        const char* name;
        double nanometres, f0, schlick, lazanyi;
    };
    for (const Row& row : {Row{"gold", 650, 0.957, 0.0165, 0.0050}, Row{"gold", 450, 0.408, 0.0179, 0.0170},
                           Row{"silver", 650, 0.990, 0.0064, 0.00116}, Row{"copper", 650, 0.935, 0.0245, 0.0070},
                           Row{"aluminium", 550, 0.915, 0.0962, 0.0078}, Row{"chromium", 550, 0.554, 0.1979, 0.0236}}) {
        SCOPED_TRACE(row.name);
        const auto metal = std::ranges::find(metals(), row.name, &Metal::name);
        ASSERT_NE(metal, metals().end());
        EXPECT_FALSE(metal->source.empty());
        const Complex n = metal->index(row.nanometres);
        EXPECT_NEAR(fresnel_conductor(1, 1, n.eta, n.k), row.f0, 0.002);
        EXPECT_NEAR(of_schlick(n.eta, n.k).most, row.schlick, 0.1 * row.schlick);
        EXPECT_NEAR(of_lazanyi(n.eta, n.k).most, row.lazanyi, 0.1 * row.lazanyi);
    }
}

// Hard case 70 for this rung, and what the term is for: it is right where Schlick's shape is most wrong.
TEST(ConductorLadder, TheDipIsWhereItShouldBe) {
    for (const Metal& metal : metals())
        for (double nm = 400; nm <= 750; nm += 10) {
            const Complex n = metal.index(nm);
            const double f0 = fresnel_conductor(1, 1, n.eta, n.k), a = lazanyi_depth(n.eta, n.k);
            EXPECT_NEAR(lazanyi(1.0 / 7, f0, a), fresnel_conductor(1.0 / 7, 1, n.eta, n.k), 1e-12) << metal.name;
            EXPECT_EQ(lazanyi(1, f0, a), f0);
            EXPECT_EQ(lazanyi(0, f0, a), 1.0);
            for (double c = -0.1; c <= 1.1; c += 0.01) {
                EXPECT_GE(lazanyi(c, f0, a), 0.0);
                EXPECT_LE(lazanyi(c, f0, a), 1.0);
            }
        }
}

}  // namespace
}  // namespace snell::optics
