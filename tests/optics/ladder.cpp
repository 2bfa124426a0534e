// The ladder of Fresnel's reflectance: what each rung is wrong by, and what all of them must keep.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "tests/hard_case.h"
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

struct Rung {
    std::string name;
    std::function<double(double c, double n1, double n2)> reflectance;
};
const std::vector<Rung>& rungs() {
    static const std::vector<Rung> all = {
        {"f0", [](double, double n1, double n2) { return normal_reflectance(n1, n2); }},
        {"1 - cos", [](double c, double, double) { return 1 - std::clamp(c, 0.0, 1.0); }},
        {"Schlick, power 2", [](double c, double n1, double n2) { return schlick(c, normal_reflectance(n1, n2), 2); }},
        {"Cg", [](double c, double, double) { return cg_fresnel(c, .3, 2, 2); }},
        {"Schlick", [](double c, double n1, double n2) { return schlick_dielectric(c, n1, n2); }},
        {"Cg, fitted", [](double c, double, double) { return cg_fresnel(c, .048, .848, 4.55); }},
        {"Gaussian", [](double c, double n1, double n2) { return gaussian_dielectric(c, n1, n2); }},
        {"exact", [](double c, double n1, double n2) { return fresnel(c, n1, n2); }},
    };
    return all;
}

// Over the disc that a distant ball covers: weight 2 c dc.
struct Error {
    double mean = 0, largest = 0;
};
Error error(const Rung& rung, double n1, double n2) {
    Error e;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double c = (i + 0.5) / steps;
        const double off = std::abs(rung.reflectance(c, n1, n2) - fresnel(c, n1, n2));
        e.mean += 2 * c * off / steps;
        e.largest = std::max(e.largest, off);
    }
    return e;
}

TEST(FresnelLadder, HasTheErrorsItPrints) {
    const struct {
        double mean, largest;
    } printed[] = {{.052, .957},   {.242, .489},  {.107, .315}, {.476, .869},
                   {.0090, .0345}, {.0049, .104}, {.0077, .038}};
    for (std::size_t i = 0; i < std::size(printed); ++i) {
        const Error e = error(rungs()[i], 1, 1.52);
        EXPECT_NEAR(e.mean / printed[i].mean, 1, 0.1) << rungs()[i].name << ": " << e.mean;
        EXPECT_NEAR(e.largest / printed[i].largest, 1, 0.1) << rungs()[i].name << ": " << e.largest;
    }
}

TEST(FresnelLadder, FromInsideNeedsTheTransmittedCosine) {
    const double printed[] = {.566, .309, .407, .252, .0039, .515, .0033};
    for (std::size_t i = 0; i < std::size(printed); ++i)
        EXPECT_NEAR(error(rungs()[i], 1.52, 1).mean / printed[i], 1, 0.1) << rungs()[i].name;
    const Rung naive{"naive", [](double c, double n1, double n2) { return schlick(c, normal_reflectance(n1, n2)); }};
    EXPECT_NEAR(error(naive, 1.52, 1).mean / .52, 1, 0.1);
}

// In [0,1], and growing toward grazing; for cosines above 1 too.
TEST(FresnelLadder, EveryRungIsAReflectance) {
    int outside = 0, falling = 0, printed = 0;
    for (const Rung& rung : rungs())
        for (double n : {1.0003, 1.31, 1.33, 1.52, 2.42}) {
            double before = 0;
            for (int i = 0; i <= 2000; ++i) {
                const double f = rung.reflectance(std::cos(i * std::acos(0.0) / 2000), 1, n);
                outside += !(f >= 0 && f <= 1);
                falling += !(f >= before - 1e-15);
                before = f;
            }
            for (double c : {-1e-7, -1.0, 1 + 3.6e-7, 1e30, -1e30}) {
                const double f = rung.reflectance(c, 1, n);
                outside += !(f >= 0 && f <= 1);
            }
        }
    for (double c = 0; c <= 1; c += 1.0 / 2000) printed += .04 + .96 * std::pow(1 + c, 5.0) > 1;
    test::hard_case({"70", "reflectances lie in [0,1] and grow toward grazing, every rung; naive: 1 + cos as printed",
                     "cosines where not", 0, static_cast<double>(outside + falling), static_cast<double>(printed)});
}

// "1 + cos" printed for "1 - cos" is found by the same property.
TEST(FresnelLadder, APrintedMistakeIsNoReflectance) {
    const double f0 = normal_reflectance(1, 1.52);
    EXPECT_GT(f0 + (1 - f0) * std::pow(1 + 1.0, 2.0), 3.8);
}

// What claims reciprocity keeps it: the same from both ends of a ray.
TEST(FresnelLadder, ExactSchlickAndGaussianAreReciprocal) {
    double worst = 0, incident_cosine = 0;
    for (std::size_t i : {4U, 6U, 7U})
        for (double n : {1.0003, 1.33, 1.52, 2.42})
            for (double c = 0.01; c <= 1; c += 0.01) {
                const double there = rungs()[i].reflectance(c, 1, n), t = std::sqrt(transmitted_cos2(c, 1, n));
                worst = std::max(worst, std::abs(there - rungs()[i].reflectance(t, n, 1)));
                incident_cosine = std::max(incident_cosine, std::abs(there - schlick(t, normal_reflectance(n, 1))));
            }
    test::hard_case({"11",
                     "reciprocity: as much is reflected from inside as from outside; naive: Schlick by the "
                     "incident cosine",
                     "of the light", 2e-6, worst, incident_cosine});
}

// Textbook formulas in float lose everything for air in vacuum; the library's form keeps it. The
// reference is the same formula in double, backward error in units of the cosine's last place.
float textbook(float c, float n1, float n2) {
    const float eta = n1 / n2, t = std::sqrt(std::max(0.0F, 1 - eta * eta * (1 - c * c)));
    const float s = (n1 * c - n2 * t) / (n1 * c + n2 * t), p = (n2 * c - n1 * t) / (n2 * c + n1 * t);
    return 0.5F * (s * s + p * p);
}
float library(float c, float n1, float n2) {
    if (n1 == n2) return 0;
    const float k = ((n2 - n1) * (n2 + n1) + n1 * n1 * c * c) / (n2 * n2);
    if (!(k > 0)) return 1;
    const float t = std::sqrt(k), d = n1 * c + n2 * t, rs = (n1 - n2) * (n1 + n2) / (d * d);
    const float p = c * t, q = n1 / n2 * (1 - c) * (1 + c), r = (p - q) / (p + q);
    return 0.5F * rs * rs * (1 + r * r);
}
TEST(HardOptics, NearlyEqualIndicesInFloat) {
    double worst_textbook = 0, worst_library = 0;
    const float n = 1.0003F;
    for (int i = 1; i < 100000; ++i) {
        const float c = static_cast<float>(i) / 100000;
        const double truth = fresnel(c, 1, n);
        worst_textbook = std::max(worst_textbook, std::abs(textbook(c, 1, n) - truth));
        worst_library = std::max(worst_library, std::abs(library(c, 1, n) - truth));
    }
    test::hard_case({"9", "exact Fresnel in float where n is 1.0003: difference of squares, not of products",
                     "of the light", 2e-6, worst_library, worst_textbook});
}

// As a square of a difference it keeps its digits, as what is not transmitted it loses all.
TEST(HardOptics, NormalReflectanceOfNearlyEqualIndicesInFloat) {
    double worst = 0;
    for (float n : {1.1F, 1.0003F, 1.000001F})
        worst = std::max(worst, std::abs(library(1, 1, n) / normal_reflectance(1, n) - 1));
    const float n = 1.0003F, not_transmitted = 1 - 4 * n / ((1 + n) * (1 + n));
    test::hard_case({"10", "f0 of nearly equal indices in float; naive: 1 less what is transmitted", "relative", 1e-5,
                     worst, std::abs(not_transmitted / normal_reflectance(1, n) - 1)});
}

// At the critical angle itself, whichever way rounding goes, the answer is that of a neighbouring
// cosine, and everything is reflected on both sides.
TEST(HardOptics, TheCriticalAngleInFloat) {
    int backward = 0;
    for (float n : {1.31F, 1.33F, 1.47F, 1.5F, 1.52F, 2.16F, 2.42F, 2.69F}) {
        const double critical = std::cos(*critical_angle(n, 1));
        float c = static_cast<float>(critical);
        for (int i = 0; i < 200; ++i) c = std::nextafter(c, 0.0F);
        int flips = 0;
        bool total_before = true;
        for (int i = 0; i < 400; ++i, c = std::nextafter(c, 1.0F)) {
            const float f = library(c, n, 1);
            const bool total = f == 1;
            flips += total != total_before;
            total_before = total;
            // How many units of its last place the cosine must be moved for the exact answer to be this one.
            const double ulp = c - std::nextafter(c, 0.0F);
            const auto reached = [&](int ulps) {
                const double a = fresnel(c - ulps * ulp, n, 1), b = fresnel(c + ulps * ulp, n, 1);
                return f >= std::min(a, b) - 1e-6 && f <= std::max(a, b) + 1e-6;
            };
            int ulps = 0;
            while (ulps < 100 && !reached(ulps)) ++ulps;
            backward = std::max(backward, ulps);
        }
        EXPECT_LE(flips, 1) << n;
    }
    test::hard_case({"1",
                     "the critical angle in float, n from 1.31 to 2.69: the answer is that of a neighbouring cosine",
                     "units of the cosine's last place", 2, static_cast<double>(backward), std::nullopt});
}

// A ray that came through one side of a slab leaves by the other, however flat it is.
TEST(HardOptics, WhatEnteredASlabLeavesIt) {
    for (double n : {1.0003, 1.33, 1.5, 2.42})
        for (double c = 1; c > 1e-9; c *= 0.9) {
            const glm::dvec3 incident(std::sqrt((1 - c) * (1 + c)), 0, -c);
            const auto in = meet(incident, {0, 0, 1}, 1, n);
            ASSERT_FALSE(in->total);
            const auto out = meet(in->transmitted, {0, 0, -1}, 1, n);
            EXPECT_EQ(out->side, Side::inside);
            EXPECT_FALSE(out->total) << n << " " << c;
            // Next to the critical angle a rounding of the cosine is the square root of it in the angle.
            EXPECT_LT(angle_between(out->transmitted, incident), 4e-16 / c * 10 + 3e-8) << n << " " << c;
        }
}

// Equal indices change nothing, at grazing incidence too; GLSL's formula turns the ray.
TEST(HardOptics, EqualIndicesInFloat) {
    double formula = 0, worst = 0;
    for (float c = 1; c > 1e-4F; c *= 0.97F) {
        const float k = 1 - (1 - c * c);
        formula = std::max(formula, std::abs(std::sqrt(static_cast<double>(k)) - c));
        const float stable = (1.0F - 1.0F) * (1.0F + 1.0F) + c * c;
        worst = std::max(worst, std::abs(std::sqrt(static_cast<double>(stable)) - c));
    }
    test::hard_case({"3", "equal indices in float: the transmitted cosine is the incident one; naive: 1 - eta²(1 - c²)",
                     "of the cosine", 1e-7, worst, formula});
}

TEST(HardOptics, SmallAnglesByAtan2) {
    double worst = 0;
    for (double angle : {1e-3, 1e-6, 1e-9, 1e-12}) {
        const glm::dvec3 a(1, 0, 0), b(std::cos(angle), std::sin(angle), 0);
        worst = std::max(worst, std::abs(angle_between(a, b) / angle - 1));
    }
    test::hard_case({"13", "angles from 1e-3 to 1e-12 rad by atan2; naive: acos of a float at 1e-4", "relative", 1e-9,
                     worst, std::abs(std::acos(static_cast<float>(std::cos(1e-4))) / 1e-4 - 1)});
}

// From the back, the same as from the front with the other index.
TEST(HardOptics, TheBackOfASurface) {
    const glm::dvec3 incident = *unit({0.3, 0.2, -1});
    const auto front = meet(incident, {0, 0, 1}, 1.5, 1), back = meet(incident, {0, 0, -1}, 1, 1.5);
    EXPECT_EQ(back->side, Side::inside);
    EXPECT_EQ(back->n1, 1.5);
    test::hard_case({"6", "the back of a surface (N·I > 0): flipped, and the other ratio; naive: refract() as it is",
                     "rad", 1e-15, angle_between(front->transmitted, back->transmitted),
                     angle_between(glsl_refract(incident, {0, 0, -1}, 1 / 1.5), front->transmitted)});
}

// No result, rather than a wrong one, from indices and vectors that mean nothing.
TEST(HardOptics, MeaninglessInputHasNoResult) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
    for (double n : {0.0, -0.0, -0.66, nan, inf, -inf}) {
        EXPECT_FALSE(meet({0, 0, -1}, {0, 0, 1}, 1, n)) << n;
        EXPECT_FALSE(meet({0, 0, -1}, {0, 0, 1}, n, 1)) << n;
    }
    for (const glm::dvec3& v : {glm::dvec3(0), glm::dvec3(nan, 0, 1), glm::dvec3(0, inf, 0)}) {
        EXPECT_FALSE(meet(v, {0, 0, 1}, 1, 1.5));
        EXPECT_FALSE(meet({0, 0, -1}, v, 1, 1.5));
    }
    const auto huge = meet({0, 0, -1e300}, {0, 0, 1e-300}, 1, 1e20);
    ASSERT_TRUE(huge);
    EXPECT_LT(angle_between(huge->transmitted, {0, 0, -1}), 1e-15);
}

}  // namespace
}  // namespace snell::optics
