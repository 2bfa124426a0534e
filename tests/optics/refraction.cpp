#include "tests/oracle/optics/refraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace snell::optics {
namespace {

using std::numbers::pi;

glm::dvec3 random_direction(std::mt19937& random) {
    std::normal_distribution<double> gauss;
    return *unit({gauss(random), gauss(random), gauss(random)});
}

// A ray that meets the plane y = 0 from above at an angle from the normal.
glm::dvec3 ray_down(double angle) { return {std::sin(angle), -std::cos(angle), 0.0}; }
const glm::dvec3 upward(0, 1, 0);

TEST(Mirror, AnglesAreEqualAndTheVectorStaysInThePlane) {
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 in = 3.7 * random_direction(random), n = 0.2 * random_direction(random);
        const auto out = mirror(in, n);
        ASSERT_TRUE(out);
        EXPECT_NEAR(glm::length(*out), 1.0, 1e-15);
        EXPECT_NEAR(glm::dot(*out, *unit(n)), -glm::dot(*unit(in), *unit(n)), 1e-14);
        EXPECT_NEAR(glm::dot(glm::cross(in, n), *out), 0.0, 1e-14);
    }
}

TEST(Mirror, TwiceIsTheIdentity) {
    std::mt19937 random(2);
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 in = random_direction(random), n = random_direction(random);
        EXPECT_LT(angle_between(*mirror(*mirror(in, n), n), in), 1e-14);
    }
}

TEST(Mirror, WithoutADirectionThereIsNone) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& bad : {glm::dvec3(0), glm::dvec3(nan, 0, 1), glm::dvec3(infinity, 0, 0)}) {
        EXPECT_FALSE(mirror(bad, upward));
        EXPECT_FALSE(mirror(upward, bad));
        EXPECT_FALSE(meet(bad, upward, 1, 1.5));
    }
}

TEST(Unit, KeepsTheDirectionOfVectorsWhoseSquaresLeaveTheRange) {
    for (double scale : {1e-300, 1e-200, 1.0, 1e200, 1e300}) {
        const auto u = unit(scale * glm::dvec3(1, 2, -2));
        ASSERT_TRUE(u) << scale;
        EXPECT_LT(angle_between(*u, {1, 2, -2}), 1e-15) << scale;
    }
}

TEST(Angle, SmallOnesKeepTheirDigits) {
    for (double angle : {1e-3, 1e-6, 1e-9, 1e-12})
        EXPECT_NEAR(angle_between({1, 0, 0}, {std::cos(angle), std::sin(angle), 0}) / angle, 1.0, 1e-12);
}

TEST(Refraction, ObeysSnellsLawFromBothSides) {
    for (double n : {1.0003, 1.31, 1.5, 2.42})
        for (int i = 0; i < 90; ++i) {
            const double angle = i * pi / 180;
            const auto in = meet(ray_down(angle), upward, 1.0, n);
            ASSERT_TRUE(in && !in->total);
            EXPECT_EQ(in->side, Side::outside);
            const double beyond = angle_between(in->transmitted, -upward);
            EXPECT_NEAR(std::sin(angle), n * std::sin(beyond), 4e-15);
            // The same path backwards leaves as it came.
            const auto back = meet(-in->transmitted, upward, 1.0, n);
            ASSERT_TRUE(back);
            EXPECT_EQ(back->side, Side::inside);
            if (back->total) continue;  // by rounding, at grazing incidence
            EXPECT_LT(angle_between(back->transmitted, -ray_down(angle)), 2e-6);
        }
}

TEST(Refraction, StaysInThePlaneOfIncidenceAndOnTheOtherSide) {
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 in = random_direction(random), n = random_direction(random);
        const auto m = meet(in, n, 1.0, 1.5);
        ASSERT_TRUE(m);
        EXPECT_NEAR(glm::dot(glm::cross(in, n), m->transmitted), 0.0, 1e-14);
        EXPECT_NEAR(glm::length(m->transmitted), 1.0, 1e-15);
        if (m->total) continue;
        EXPECT_GE(glm::dot(in, n) * glm::dot(m->transmitted, n), 0.0);
    }
}

TEST(Refraction, LengthsOfTheVectorsDoNotMatter) {
    const auto a = meet(ray_down(0.7), upward, 1.0, 1.5), b = meet(4.2 * ray_down(0.7), 0.013 * upward, 1.0, 1.5);
    EXPECT_LT(angle_between(a->transmitted, b->transmitted), 1e-15);
}

TEST(Refraction, BetweenEqualIndicesNothingHappensEvenAtGrazingIncidence) {
    for (double angle : {0.0, 0.5, 1.5, 1.57, pi / 2 - 1e-6}) {
        const auto m = meet(ray_down(angle), upward, 1.3, 1.3);
        EXPECT_FALSE(m->total);
        EXPECT_LT(angle_between(m->transmitted, ray_down(angle)), 1e-12) << angle;
    }
}

TEST(Refraction, TotalReflectionBeginsAtTheCriticalAngle) {
    for (double n : {1.31, 1.5, 2.42}) {
        const double critical = *critical_angle(n, 1.0);
        const auto from_inside = [&](double angle) { return *meet(-ray_down(angle), upward, 1.0, n); };
        EXPECT_FALSE(from_inside(critical - 1e-9).total);
        const Interface beyond = from_inside(critical + 1e-9);
        EXPECT_TRUE(beyond.total);
        EXPECT_EQ(beyond.transmitted, beyond.reflected);
        EXPECT_GT(from_inside(critical - 1e-9).cos_transmitted, 0.0);
        // Near it the transmitted ray runs along the surface.
        EXPECT_NEAR(angle_between(from_inside(critical - 1e-9).transmitted, upward), pi / 2, 1e-4);
    }
    EXPECT_FALSE(critical_angle(1.0, 1.5));
    EXPECT_FALSE(critical_angle(1.5, 1.5));
}

TEST(Refraction, UnusableIndicesGiveNothing) {
    for (double n : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
        EXPECT_FALSE(meet(ray_down(0.3), upward, 1.0, n)) << n;
    for (double n : {1e-20, 1e20}) EXPECT_TRUE(meet(ray_down(0.3), upward, 1.0, n)) << n;
}

TEST(Glsl, AgreesWithPhysicsForUnitVectors) {
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 n = random_direction(random);
        glm::dvec3 in = random_direction(random);
        if (glm::dot(in, n) > 0) in = -in;
        const auto m = meet(in, n, 1.0, 1.5);
        EXPECT_LT(glm::length(glsl_refract(in, n, 1 / 1.5) - m->transmitted), 1e-14);
        EXPECT_LT(glm::length(glsl_reflect(in, n) - m->reflected), 1e-14);
    }
}

TEST(Glsl, PastTheCriticalAngleIsTheZeroVector) {
    EXPECT_EQ(glsl_refract(ray_down(1.0), upward, 1.5), glm::dvec3(0));
    EXPECT_NE(glsl_refract(ray_down(0.5), upward, 1.5), glm::dvec3(0));
}

// What the seeds' shader does: a view vector as long as the distance is.
TEST(Glsl, LongVectorsGoWrongByDegrees) {
    const glm::dvec3 right = glsl_refract(ray_down(0.6), upward, 0.66),
                     wrong = glsl_refract(4.0 * ray_down(0.6), upward, 0.66);
    EXPECT_GT(angle_between(right, wrong), 5 * pi / 180);
    EXPECT_NEAR(wrong.x, 0.66 * 4.0 * std::sin(0.6), 1e-15);
    const double d = -4.0 * std::cos(0.6), k = 1 - 0.66 * 0.66 * (1 - d * d);
    EXPECT_NEAR(wrong.y, 0.66 * d - (0.66 * d + std::sqrt(k)), 1e-14);
}

TEST(Sphere, LeavingByTheChordIsARefractionAtTheOtherEnd) {
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 entry = random_direction(random);
        glm::dvec3 in = random_direction(random);
        if (glm::dot(in, entry) > 0) in = -in;
        const glm::dvec3 inside = meet(in, entry, 1.0, 1.5)->transmitted;
        const glm::dvec3 exit = entry - 2.0 * glm::dot(entry, inside) * inside;
        EXPECT_NEAR(glm::length(exit), 1.0, 1e-14);
        const auto out = meet(inside, exit, 1.0, 1.5);
        ASSERT_EQ(out->side, Side::inside);
        if (out->total) continue;  // by rounding, at grazing incidence: what the closed form can't do
        EXPECT_LT(angle_between(out->transmitted, leave_sphere(in, inside)), 1e-6);
    }
}

}  // namespace
}  // namespace snell::optics
