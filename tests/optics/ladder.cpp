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
struct Misfit {
    double mean = 0, largest = 0;
};
Misfit error(const Rung& rung, double n1, double n2) {
    Misfit e;
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
        const Misfit e = error(rungs()[i], 1, 1.52);
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
