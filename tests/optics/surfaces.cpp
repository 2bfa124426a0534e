// The laws that light keeps at a surface, by which the oracle is judged.
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/std.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

constexpr double indices[] = {1.0003, 1.31, 1.33, 1.5, 1.52, 2.42, 4.0};

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> gauss;
    return *unit({gauss(random), gauss(random), gauss(random)});
}

// A ray that meets the plane y = 0 from above at an angle from the normal.
glm::dvec3 ray_down(double angle) { return {std::sin(angle), -std::cos(angle), 0.0}; }
const glm::dvec3 upward(0, 1, 0);

TEST(Vectors, KeepTheirDigits) {
    for (const double scale : {1e-300, 1e-200, 1.0, 1e200, 1e300})
        EXPECT_LT(angle_between(unit(scale * glm::dvec3(1, 2, -2)).value(), {1, 2, -2}), 1e-15) << scale;
    for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12})
        EXPECT_NEAR(angle_between({1, 0, 0}, {std::cos(angle), std::sin(angle), 0}) / angle, 1.0, 1e-12);
}

TEST(Surface, LightStaysInThePlaneOfIncidence) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 in = 3.7 * random_direction(random), n = 0.2 * random_direction(random);
        const auto m = meet(in, n, 1.0, 1.5);
        ASSERT_TRUE(m);
        EXPECT_LT(glm::length(m->reflected - *mirror(in, n)), 1e-14);
        EXPECT_NEAR(glm::dot(m->reflected, *unit(n)), -glm::dot(*unit(in), *unit(n)), 1e-14) << "angles are equal";
        for (const glm::dvec3& out : {m->reflected, m->transmitted}) {
            EXPECT_NEAR(glm::length(out), 1.0, 1e-15);
            EXPECT_NEAR(glm::dot(glm::cross(in, n), out), 0.0, 1e-14);
        }
        if (m->total) continue;
        EXPECT_GE(glm::dot(in, n) * glm::dot(m->transmitted, n), 0.0) << "on the other side";
        // What GLSL has, where it is right.
        const glm::dvec3 facing = glm::dot(in, n) > 0 ? -*unit(n) : *unit(n);
        EXPECT_LT(glm::length(glsl_refract(*unit(in), facing, m->n1 / m->n2) - m->transmitted), 1e-7);
    }
}

TEST(Surface, ObeysSnellsLawFromBothSides) {
    for (const double n : indices)
        for (double c = 1; c > 1e-9; c *= 0.9) {
            const glm::dvec3 incident(std::sqrt((1 - c) * (1 + c)), -c, 0);
            const auto in = meet(incident, upward, 1.0, n);
            ASSERT_TRUE(in && !in->total && in->side == Side::outside);
            EXPECT_NEAR(incident.x, n * std::sin(angle_between(in->transmitted, -upward)), 1e-14);
            // The same path backwards leaves as it came, however flat it is. Next to the critical angle a rounding of
            // the cosine is the square root of it in the angle.
            const auto back = meet(-in->transmitted, upward, 1.0, n);
            ASSERT_TRUE(back && !back->total && back->side == Side::inside) << n << " " << c;
            EXPECT_LT(angle_between(back->transmitted, -incident), 4e-15 / c * n + 6e-8) << n << " " << c;
        }
}

TEST(Surface, BetweenEqualIndicesIsNone) {
    for (const double angle : {0.0, 0.5, 1.5, 1.57, pi / 2 - 1e-6}) {
        const auto m = meet(ray_down(angle), upward, 1.3, 1.3);
        EXPECT_FALSE(m->total);
        EXPECT_LT(angle_between(m->transmitted, ray_down(angle)), 1e-12) << angle;
        EXPECT_EQ(fresnel(m->cos_incident, 1.3, 1.3), 0.0);
    }
}

TEST(Surface, TotalReflectionBeginsAtTheCriticalAngle) {
    for (const double n : {1.31, 1.5, 2.42}) {
        const double critical = *critical_angle(n, 1.0);
        const auto from_inside = [&](double angle) { return *meet(-ray_down(angle), upward, 1.0, n); };
        const Interface before = from_inside(critical - 1e-9), beyond = from_inside(critical + 1e-9);
        EXPECT_FALSE(before.total);
        EXPECT_NEAR(angle_between(before.transmitted, upward), pi / 2, 1e-4) << "along the surface";
        EXPECT_TRUE(beyond.total);
        EXPECT_EQ(beyond.transmitted, beyond.reflected);
        EXPECT_LT(fresnel(std::cos(critical) + 1e-3, n, 1.0), 1.0);
        EXPECT_EQ(fresnel(std::cos(critical) - 1e-6, n, 1.0), 1.0);
    }
    EXPECT_FALSE(critical_angle(1.0, 1.5));
    EXPECT_FALSE(critical_angle(1.5, 1.5));
}

// No result, rather than a wrong one, from indices and vectors that mean nothing.
TEST(Surface, MeaninglessInputHasNoResult) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
    for (const double n : {0.0, -0.0, -0.66, nan, inf, -inf}) {
        EXPECT_FALSE(meet(ray_down(0.3), upward, 1, n)) << n;
        EXPECT_FALSE(meet(ray_down(0.3), upward, n, 1)) << n;
    }
    for (const glm::dvec3& v : {glm::dvec3(0), glm::dvec3(nan, 0, 1), glm::dvec3(0, inf, 0)}) {
        EXPECT_FALSE(meet(v, upward, 1, 1.5));
        EXPECT_FALSE(meet(upward, v, 1, 1.5));
        EXPECT_FALSE(mirror(v, upward));
    }
    EXPECT_LT(angle_between(meet({0, 0, -1e300}, {0, 0, 1e-300}, 1, 1e20).value().transmitted, {0, 0, -1}), 1e-15);
}

// The transmitted part, from the amplitudes of Fresnel's equations: T = (n2 cos t) / (n1 cos i) · t².
TEST(Reflectance, WhatIsNotReflectedIsTransmittedAndBothWaysAreAlike) {
    for (const double n : indices)
        for (int i = 0; i < 90; ++i) {
            const double c = std::cos(i * pi / 180), t = std::sqrt(transmitted_cos2(c, 1, n)), beam = n * t / c;
            const double s = 2 * c / (c + n * t), p = 2 * c / (n * c + t);
            const Polarised r = fresnel_polarised(c, 1, n);
            EXPECT_NEAR(r.s + beam * s * s, 1.0, 1e-12) << n << " at " << i;
            EXPECT_NEAR(r.p + beam * p * p, 1.0, 1e-12) << n << " at " << i;
            EXPECT_NEAR(r.mean(), fresnel(t, n, 1), 1e-11) << n << " at " << i;
        }
}

TEST(Reflectance, HasItsLimits) {
    for (const double n : indices) {
        const Polarised r = fresnel_polarised(std::cos(brewster_angle(1, n)), 1, n);
        EXPECT_NEAR(r.p, 0, 1e-15) << "Brewster's angle " << n;
        EXPECT_NEAR(std::sqrt(r.s), (n * n - 1) / (n * n + 1), 1e-14) << n;
        EXPECT_NEAR(fresnel(1, 1, n) / normal_reflectance(1, n), 1.0, 1e-12) << n;
        EXPECT_NEAR(fresnel(1e-9, 1, n), 1.0, 1e-5) << n;
        EXPECT_NEAR(fresnel(0, 1, n), 1.0, 1e-15) << n;
    }
    // For n = 1 + e, R at normal incidence is (e / (2 + e))², whatever e is.
    for (const double e : {1e-4, 1e-8, 1e-12}) {
        const double n = 1.0 + e, exact = n - 1.0, amplitude = exact / (2 + exact);
        EXPECT_NEAR(fresnel(1, 1, n) / (amplitude * amplitude), 1.0, 1e-12) << e;
    }
}

// Fresnel's amplitudes in complex arithmetic.
TEST(Reflectance, OfMetalsAgreesWithComplexArithmetic) {
    const auto by_complex_numbers = [](double c, double n1, std::complex<double> n2) {
        const std::complex<double> s2 = n1 * n1 * (1 - c * c), t = std::sqrt(n2 * n2 - s2) / n2;
        return Polarised{std::norm((n1 * c - n2 * t) / (n1 * c + n2 * t)),
                         std::norm((n2 * c - n1 * t) / (n2 * c + n1 * t))};
    };
    for (const double n1 : {1.0, 1.33, 2.42})
        for (const double eta : {0.04, 0.43, 1.0, 1.5, 3.0})
            for (double c = 0.01; c <= 1; c += 0.01) {
                for (const double k : {0.3, 1.9, 4.5, 12.0}) {
                    const Polarised mine = fresnel_conductor_polarised(c, n1, eta, k);
                    const Polarised truth = by_complex_numbers(c, n1, {eta, k});
                    EXPECT_NEAR(mine.s, truth.s, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                    EXPECT_NEAR(mine.p, truth.p, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                }
                EXPECT_NEAR(fresnel_conductor(c, n1, eta, 0), fresnel(c, n1, eta), 1e-7) << "without absorption";
            }
    EXPECT_NEAR(lazanyi(1.0 / 7, fresnel_conductor(1, 1, .96, 6.69), lazanyi_depth(.96, 6.69)),
                fresnel_conductor(1.0 / 7, 1, .96, 6.69), 1e-12)
        << "the dip is where absorption makes it";
}

}  // namespace
}  // namespace snell::optics
