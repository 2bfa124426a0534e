#include "tests/oracle/optics/sphere.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/hard_case.h"
#include "tests/oracle/optics/ray.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

// A ray along -z that meets the ball of radius 1 at distance b from its axis.
struct Impact {
    glm::dvec3 incident{0, 0, -1}, normal;
    explicit Impact(double b) : normal(b, 0, std::sqrt((1 - b) * (1 + b))) {}
};

// The path as geometry has it: chords that end on the ball, refracted or mirrored at each end.
std::vector<glm::dvec3> by_geometry(const Impact& impact, double n, int orders) {
    std::vector<glm::dvec3> out;
    glm::dvec3 at = impact.normal, inside = meet(impact.incident, at, 1, n)->transmitted;
    for (int order = 1; order <= orders; ++order) {
        at = *unit(at - 2.0 * glm::dot(at, inside) * inside);
        const auto met = meet(inside, at, 1, n);
        EXPECT_EQ(met->side, Side::inside);
        out.push_back(met->transmitted);
        inside = met->reflected;
    }
    return out;
}

TEST(ThroughSphere, FollowsTheChords) {
    for (double n : {1.31, 1.5, 2.42})
        for (double b : {0.0, 0.01, 0.3, 0.6, 0.9, 0.99}) {
            const Impact impact(b);
            const auto expected = by_geometry(impact, n, 6);
            const auto light = through_sphere(impact.incident, impact.normal, 1, n, 6);
            for (std::size_t i = 1; i < light.exits.size(); ++i)
                EXPECT_LT(angle_between(light.exits[i].direction, expected[i - 1]), 2e-7)
                    << "n " << n << " b " << b << " order " << i;
        }
}

TEST(ThroughSphere, TheFirstExitIsTheClosedForm) {
    for (double b : {0.0, 0.2, 0.7, 0.999}) {
        const Impact impact(b);
        const auto light = through_sphere(impact.incident, impact.normal, 1, 1.5);
        const glm::dvec3 inside = meet(impact.incident, impact.normal, 1, 1.5)->transmitted;
        EXPECT_LT(angle_between(light.exits.at(1).direction, leave_sphere(impact.incident, inside)), 1e-14) << b;
    }
}

// Rainbow: after one reflection inside, water turns light by at least 138 degrees (Descartes), at b = .861.
TEST(ThroughSphere, MakesTheRainbow) {
    double least = pi, where = 0;
    for (int i = 1; i < 2000; ++i) {
        const Impact impact(i / 2000.0);
        const auto light = through_sphere(impact.incident, impact.normal, 1, 4.0 / 3, 2);
        const double turned = angle_between(impact.incident, light.exits.at(2).direction);
        if (turned < least) least = turned, where = i / 2000.0;
    }
    EXPECT_NEAR(least * 180 / pi, 137.97, 0.01);
    EXPECT_NEAR(where, 0.8607, 0.002);
}

// What has come out and what is still inside is all there was; both polarisations apart as well.
TEST(ThroughSphere, LosesNoLight) {
    for (double n : {1.0003, 1.33, 1.5, 2.42, 0.7})
        for (double b : {0.0, 0.5, 0.69, 0.9, 0.999, 0.9999999}) {
            const Impact impact(b);
            for (int orders : {0, 1, 2, 5, 32}) {
                const auto light = through_sphere(impact.incident, impact.normal, 1, n, orders);
                double sum = light.inside;
                for (const Exit& exit : light.exits) sum += exit.energy;
                EXPECT_NEAR(sum, 1.0, 1e-12) << n << " " << b << " " << orders;
            }
        }
}

TEST(ThroughSphere, PolarisedEnergyAddsUpToo) {
    const Impact impact(0.8);
    const auto light = through_sphere(impact.incident, impact.normal, 1, 1.5);
    double s = 0, p = 0;
    for (const Exit& exit : light.exits) s += exit.polarised.s, p += exit.polarised.p;
    EXPECT_NEAR(s, 1.0, 1e-3);
    EXPECT_NEAR(p, 1.0, 1e-3);
}

TEST(ThroughSphere, TheSeriesEnds) {
    for (double b = 0; b < 1; b += 0.001) {
        const Impact impact(b);
        const auto light = through_sphere(impact.incident, impact.normal, 1, 1.5);
        ASSERT_LE(light.exits.size(), 33U);
        EXPECT_TRUE(light.exits.size() == 33U || light.inside < series_end) << b;
        if (light.exits.size() > 2U) {
            const auto shorter =
                through_sphere(impact.incident, impact.normal, 1, 1.5, static_cast<int>(light.exits.size()) - 2);
            EXPECT_GE(shorter.inside, series_end) << "one exit fewer would have done at " << b;
        }
    }
    std::size_t longest = 0;
    for (double b = 0.9; b < 1; b += 1e-4)
        longest =
            std::max(longest, through_sphere(Impact(b).incident, Impact(b).normal, 1, 1.5, 1000000).exits.size() - 1);
    const auto all = through_sphere(Impact(0.5).incident, Impact(0.5).normal, 1, 1.5, 1000000);
    EXPECT_LE(all.exits.size(), 33U);
    // At the rim nearly everything stays inside: what a loop until less than 1e-4 is left would take.
    const double kept = fresnel(1e-5, 1, 1.5), endless = std::ceil(std::log(series_end) / std::log(kept));
    test::hard_case({"15",
                     "the series of inner bounces ends, a million asked for; naive: until 1e-4 is left, at the rim",
                     "bounces", 32, static_cast<double>(longest), endless});
}

TEST(ThroughSphere, ABubbleReflectsTotallyPastTheCriticalAngle) {
    const double critical = 1 / 1.33;
    const auto light = through_sphere(Impact(critical + 1e-9).incident, Impact(critical + 1e-9).normal, 1.33, 1);
    ASSERT_EQ(light.exits.size(), 1U);
    EXPECT_EQ(light.exits[0].energy, 1.0);
    EXPECT_GT(through_sphere(Impact(critical - 1e-3).incident, Impact(critical - 1e-3).normal, 1.33, 1).exits.size(),
              1U);
}

TEST(ThroughSphere, NothingInNothingOut) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(through_sphere({0, 0, 0}, {0, 0, 1}, 1, 1.5).exits.empty());
    EXPECT_TRUE(through_sphere({0, 0, -1}, {nan, 0, 1}, 1, 1.5).exits.empty());
    EXPECT_TRUE(through_sphere({0, 0, 1}, {0, 0, 1}, 1, 1.5).exits.empty());
    for (double n : {0.0, -0.0, -1.5, nan, std::numeric_limits<double>::infinity()})
        EXPECT_TRUE(through_sphere({0, 0, -1}, {0, 0, 1}, 1, n).exits.empty()) << n;
}

// Equal indices: straight on, whatever the impact.
TEST(ThroughSphere, OfAirInAirIsNotThere) {
    for (double b : {0.0, 0.5, 0.999999}) {
        const auto light = through_sphere(Impact(b).incident, Impact(b).normal, 1, 1);
        EXPECT_EQ(light.exits.at(1).energy, 1.0);
        EXPECT_LT(angle_between(light.exits.at(1).direction, {0, 0, -1}), 1e-12) << b;
    }
}

// The ladder of refraction: what the methods are wrong by, in the mean over the disc that a distant ball covers.
template <class F>
double over_disc(F f) {
    double mean = 0;
    constexpr int rings = 4000;
    for (int i = 0; i < rings; ++i) mean += f(std::sqrt((i + 0.5) / rings)) / rings;
    return mean;
}

TEST(RefractionLadder, OneInterfaceIsEighteenDegreesOff) {
    const auto error = [](double n) {
        return [n](double b) {
            const Impact impact(b);
            const glm::dvec3 single = meet(impact.incident, impact.normal, 1, n)->transmitted;
            return angle_between(single, through_sphere(impact.incident, impact.normal, 1, n).exits.at(1).direction) *
                   180 / pi;
        };
    };
    EXPECT_NEAR(over_disc(error(1.5)), 18.2, 0.05);
    EXPECT_NEAR(error(1.5)(1 - 1e-8), 48.19, 0.02);
    EXPECT_NEAR(over_disc(error(1.33)), 14.25, 0.05);
    EXPECT_NEAR(over_disc(error(2.42)), 28.93, 0.05);
    EXPECT_NEAR(error(1.5)(0.1), 1.92, 0.01);
    EXPECT_NEAR(error(1.5)(0.5), 10.53, 0.01);
    EXPECT_NEAR(error(1.5)(0.9), 27.29, 0.01);
}

// GLSL's refract with an eye vector of its natural length, as it is often written. An eye at distance 4, every pixel of
// the ball's disc.
TEST(RefractionLadder, AVectorOfTheWrongLengthIsFifteenDegreesOff) {
    const double radius = std::tan(std::asin(1.0 / 4));
    const double mean = over_disc([&](double b) {
        const Ray ray{{0, 0, 4}, *unit({b * radius, 0, -1})};
        const glm::dvec3 at = ray.at(cross_sphere(ray, glm::dvec3(0), 1).value().enter);
        const glm::dvec3 wrong = glsl_refract(at - ray.origin, at, 1 / 1.5);
        return angle_between(wrong, meet(ray.direction, at, 1, 1.5)->transmitted) * 180 / pi;
    });
    EXPECT_NEAR(mean, 14.9, 0.1);
}

TEST(RefractionLadder, LightLeftOutByOrders) {
    const double expected[3][4] = {
        {.0518, .0082, .0027, .0012}, {.0727, .0115, .0035, .0015}, {.161, .0360, .0093, .0030}};
    const double indices[3] = {1.33, 1.5, 2.42};
    for (int i = 0; i < 3; ++i)
        for (int orders = 1; orders <= 4; ++orders) {
            const auto left = over_disc([&](double b) {
                return through_sphere(Impact(b).incident, Impact(b).normal, 1, indices[i], orders).inside;
            });
            EXPECT_NEAR(left / expected[i][orders - 1], 1.0, 0.1) << indices[i] << " orders " << orders;
        }
}

// In float two refractions lose digits, the closed form does not.
TEST(RefractionLadder, ClosedFormInFloatBeatsTwoRefractions) {
    double closed = 0, twice = 0;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> any(0, 1);
    for (int i = 0; i < 100000; ++i) {
        const float b = any(random);
        const glm::vec3 normal = glm::normalize(glm::vec3(b, 0, std::sqrt((1 - b) * (1 + b)))), incident(0, 0, -1);
        const glm::dvec3 truth = through_sphere(incident, normal, 1, 1.5, 1).exits.at(1).direction;
        const glm::vec3 inside = glm::refract(incident, normal, 1 / 1.5F);
        const glm::vec3 form = 2 * glm::dot(inside, incident) * inside - incident;
        closed = std::max(closed, angle_between(form, truth));
        const glm::vec3 there = normal - 2 * glm::dot(normal, inside) * inside;
        twice = std::max(twice, angle_between(glm::refract(inside, -there, 1.5F), truth));
    }
    EXPECT_LT(closed * 180 / pi, 5e-5);
    EXPECT_GT(twice, 20 * closed);
}

}  // namespace
}  // namespace snell::optics
