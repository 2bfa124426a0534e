#include "tests/oracle/optics/two_sided.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

// The back of the unit ball, seen from far along -z.
std::optional<BackFace> ball_back(const glm::dvec3& p) {
    const double r2 = p.x * p.x + p.y * p.y;
    if (r2 > 1) return std::nullopt;
    const glm::dvec3 at(p.x, p.y, -std::sqrt(1 - r2));
    return BackFace{at, at};
}

double degrees_off(double impact, double n) {
    const glm::dvec3 front(impact, 0, std::sqrt(1 - impact * impact)), along(0, 0, -1);
    const auto truth = leave_sphere(along, meet(along, front, 1, n)->transmitted);
    return glm::degrees(angle_between(*refract_two_sided(front, along, front, 1, n, 2, ball_back), truth));
}

TEST(TwoSided, IsWithinADegreeUpToSixTenthsOfABall) {
    const double known[][2] = {{0.1, 0.002}, {0.2, 0.018}, {0.3, 0.066}, {0.4, 0.18},
                               {0.5, 0.40},  {0.6, 0.88},  {0.7, 1.93},  {0.8, 4.87}};
    for (const auto& [impact, degrees] : known)
        EXPECT_NEAR(degrees_off(impact, 1.5), degrees, 0.1 * degrees + 5e-4) << impact;
    for (double impact = 0; impact <= 0.6; impact += 0.01) EXPECT_LT(degrees_off(impact, 1.5), 1.0) << impact;
}

// Mean over the disc; at the rim the normal that is looked up is too slanted.
TEST(TwoSided, FailsAtTheRim) {
    double mean = 0, most = 0;
    for (int i = 0; i < 2000; ++i) {
        const double impact = std::sqrt((i + 0.5) / 2000), off = degrees_off(impact, 1.5);
        mean += off / 2000;
        most = std::max(most, off);
    }
    EXPECT_NEAR(mean, 4.55, 0.455);
    EXPECT_GT(most, 15);
    EXPECT_LT(mean, 18.2 / 3) << "no better than one interface";
}

TEST(TwoSided, WithoutABackIsOneRefraction) {
    const glm::dvec3 normal(0.6, 0, 0.8), along(0, 0, -1);
    const auto nothing = [](const glm::dvec3&) { return std::optional<BackFace>(); };
    EXPECT_EQ(*refract_two_sided(normal, along, normal, 1, 1.5, 2, nothing), meet(along, normal, 1, 1.5)->transmitted);
    EXPECT_FALSE(refract_two_sided(normal, {0, 0, 0}, normal, 1, 1.5, 2, nothing));
}

}  // namespace
}  // namespace snell::optics
