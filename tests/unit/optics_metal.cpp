#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "src/optics/fresnel.h"
#include "src/optics/glass.h"
#include "src/optics/refraction.h"

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

}  // namespace
}  // namespace snell::optics
