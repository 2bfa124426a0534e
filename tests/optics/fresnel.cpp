#include "tests/oracle/optics/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/hard_case.h"
#include "tests/oracle/optics/dispersion.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

constexpr double indices[] = {1.0003, 1.31, 1.33, 1.5, 1.52, 2.42, 4.0};

// The transmitted part, from the amplitudes of Fresnel's equations: T = (n2 cos t) / (n1 cos i) · t².
Polarised transmitted(double c, double n1, double n2) {
    const double t = std::sqrt(std::max(transmitted_cos2(c, n1, n2), 0.0));
    const double s = 2 * n1 * c / (n1 * c + n2 * t), p = 2 * n1 * c / (n2 * c + n1 * t);
    const double beam = n2 * t / (n1 * c);
    return {beam * s * s, beam * p * p};
}

TEST(Fresnel, WhatIsNotReflectedIsTransmitted) {
    for (double n : indices)
        for (int i = 0; i < 90; ++i) {
            const double c = std::cos(i * pi / 180);
            const Polarised r = fresnel_polarised(c, 1, n), t = transmitted(c, 1, n);
            EXPECT_NEAR(r.s + t.s, 1.0, 1e-12) << n << " at " << i;
            EXPECT_NEAR(r.p + t.p, 1.0, 1e-12) << n << " at " << i;
        }
}

TEST(Fresnel, IsTheSameInBothDirections) {
    for (double n : indices)
        for (int i = 0; i < 90; ++i) {
            const double c = std::cos(i * pi / 180), beyond = std::sqrt(transmitted_cos2(c, 1, n));
            EXPECT_NEAR(fresnel(c, 1, n), fresnel(beyond, n, 1), 1e-11) << n << " at " << i;
        }
}

TEST(Fresnel, AtBrewstersAngleOnePolarisationIsNotReflected) {
    double worst = 0;
    for (double n : indices) {
        const Polarised r = fresnel_polarised(std::cos(brewster_angle(1, n)), 1, n);
        worst = std::max({worst, r.p, 1 - fresnel(0, 1, n), std::abs(fresnel(1, 1, n) - normal_reflectance(1, n))});
        // There Rs = ((n² - 1) / (n² + 1))².
        const double expected = (n * n - 1) / (n * n + 1);
        EXPECT_NEAR(r.s, expected * expected, 1e-14) << n;
    }
    test::hard_case({"12", "Brewster's angle: nothing of p; grazing: everything; normal incidence: f0", "of the light",
                     1e-7, worst, std::nullopt});
}

TEST(Fresnel, LimitsAreNormalIncidenceAndGrazing) {
    for (double n : indices) {
        EXPECT_NEAR(fresnel(1, 1, n) / normal_reflectance(1, n), 1.0, 1e-12) << n;
        EXPECT_NEAR(fresnel(0, 1, n), 1.0, 1e-12) << n;
        EXPECT_NEAR(fresnel(1e-9, 1, n), 1.0, 1e-5) << n;
    }
    EXPECT_NEAR(normal_reflectance(1, 1.5), 0.04, 1e-16);
}

TEST(Fresnel, BetweenEqualIndicesNothingIsReflected) {
    for (double c : {0.0, 1e-6, 0.5, 1.0}) EXPECT_EQ(fresnel(c, 1.4, 1.4), 0.0);
}

TEST(Fresnel, PastTheCriticalAngleEverythingIs) {
    const double critical = std::cos(*critical_angle(1.5, 1.0));
    EXPECT_EQ(fresnel(critical - 1e-6, 1.5, 1.0), 1.0);
    EXPECT_LT(fresnel(critical + 1e-3, 1.5, 1.0), 1.0);
}

// Up to n = 2 + √3: beyond it, the unpolarised reflectance first falls.
TEST(Fresnel, LiesBetweenNoneAndAllAndGrowsTowardGrazing) {
    for (double n : indices) {
        if (n > 2 + std::sqrt(3.0)) continue;
        double before = 0;
        for (int i = 0; i <= 900; ++i) {
            const double r = fresnel(std::cos(i * pi / 1800), 1, n);
            EXPECT_GE(r, before - 1e-15) << n << " at " << i;
            EXPECT_LE(r, 1.0);
            before = r;
        }
    }
    for (double c : {-0.5, 1.0 + 4e-7, 2.0}) EXPECT_LE(fresnel(c, 1, 1.5), 1.0);  // cosines of rounded vectors
}

TEST(Fresnel, NearlyEqualIndicesKeepTheirDigits) {
    // For n = 1 + e, R at normal incidence is (e / (2 + e))², whatever e is.
    for (double e : {1e-4, 1e-8, 1e-12}) {
        const double n = 1.0 + e, exact_e = n - 1.0, expected = exact_e / (2 + exact_e) * (exact_e / (2 + exact_e));
        EXPECT_NEAR(fresnel(1, 1, n) / expected, 1.0, 1e-12) << e;
        EXPECT_NEAR(normal_reflectance(1, n) / expected, 1.0, 1e-12) << e;
    }
}

// Mean over the disc that a distant ball covers: 2 c dc.
template <class F>
double mean_error(double n, F f) {
    double sum = 0;
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps;
        sum += 2 * c * std::abs(f(c) - fresnel(c, 1, n)) / steps;
    }
    return sum;
}

TEST(Schlick, IsNineThousandthsOffForWindowGlass) {
    const double f0 = normal_reflectance(1, 1.52);
    EXPECT_NEAR(mean_error(1.52, [&](double c) { return schlick(c, f0); }), 0.0090, 0.0005);
    EXPECT_NEAR(mean_error(1.52, [&](double c) { return schlick(c, f0, 2); }), 0.107, 0.002);
    EXPECT_NEAR(mean_error(1.52, [&](double) { return f0; }), 0.052, 0.002);
    EXPECT_NEAR(mean_error(1.52, [](double c) { return cg_fresnel(c, 0.3, 2, 2); }), 0.476, 0.01);
}

TEST(Schlick, FromInsideNeedsTheCosineBeyond) {
    double right = 0, wrong = 0;
    constexpr int steps = 2000;
    const double f0 = normal_reflectance(1.52, 1);
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps, exact = fresnel(c, 1.52, 1);
        right += 2 * c * std::abs(schlick_dielectric(c, 1.52, 1) - exact) / steps;
        wrong += 2 * c * std::abs(schlick(c, f0) - exact) / steps;
    }
    EXPECT_LT(right, 0.006);
    EXPECT_GT(wrong, 0.4);
    EXPECT_EQ(schlick_dielectric(0.1, 1.52, 1), 1.0);
}

TEST(Schlick, NeverLeavesZeroToOne) {
    for (double c : {-1.0, 0.0, 0.3, 1.0, 1.0 + 4e-7})
        for (double power : {1.0, 2.0, 5.0}) {
            EXPECT_GE(schlick(c, 0.04, power), 0.04 - 1e-15);
            EXPECT_LE(schlick(c, 0.04, power), 1.0);
            EXPECT_GE(cg_fresnel(c, 0.3, 2, power), 0.0);
            EXPECT_LE(cg_fresnel(c, 0.3, 2, power), 1.0);
        }
}

TEST(Cauchy, GivesBackIndexAndAbbeNumber) {
    const Cauchy flint = cauchy_from_abbe(1.62, 36.4);
    EXPECT_NEAR(flint.index(587.56), 1.62, 1e-12);
    EXPECT_NEAR((1.62 - 1) / (flint.index(486.13) - flint.index(656.27)), 36.4, 1e-9);
}

TEST(Cauchy, BlueIsBentMost) {
    const Cauchy flint = cauchy_from_abbe(1.62, 36.4);
    double before = 3;
    for (double nm = 380; nm <= 780; nm += 10) {
        EXPECT_LT(flint.index(nm), before);
        before = flint.index(nm);
    }
}

TEST(Cauchy, StaysFiniteBeyondTheVisible) {
    const Cauchy flint = cauchy_from_abbe(1.62, 36.4);
    for (double nm : {0.0, -5.0, 1e-9, 1e9}) EXPECT_TRUE(std::isfinite(flint.index(nm))) << nm;
    for (double abbe : {0.0, -3.0, HUGE_VAL}) EXPECT_EQ(cauchy_from_abbe(1.5, abbe).index(450), 1.5) << abbe;
}

}  // namespace
}  // namespace snell::optics
