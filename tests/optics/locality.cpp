#include "tests/oracle/optics/locality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/hard_case.h"
#include "tests/oracle/optics/ray.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

const Room room{{0, 0, 0}, {5, 5, 5}};

TEST(BoxDirection, PointsAtTheWallTheRayMeets) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> inside(-4.9, 4.9), any(-1, 1);
    const Room high{{1, 2, -3}, {5, 2.5, 4}};
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 p = glm::dvec3(inside(random), inside(random), inside(random)) * high.half / 5.0;
        const glm::dvec3 d(any(random), any(random), any(random));
        const auto hit = room_hit({p, d}, high.half);
        ASSERT_TRUE(hit);
        EXPECT_LT(angle_between(box_direction(p + high.centre, d, high), *hit), 1e-12);
    }
}

// A component of zero, on a wall, outside.
TEST(BoxDirection, IsDefinedForEveryPoint) {
    int bad = 0, bad_printed = 0;
    const double values[] = {0.0, -0.0, 1.0, -1.0, 4.9999, 5.0, -5.0, 7.0, 1e30, -1e30};
    for (double x : values)
        for (double y : values)
            for (const glm::dvec3& d :
                 {glm::dvec3(0, 0, 1), glm::dvec3(0, -1, 0), glm::dvec3(1, 0, 0), glm::dvec3(0.6, 0.8, -0.0)}) {
                const glm::dvec3 seen = box_direction({x, y, 1}, d, room);
                const auto on_wall = [](const glm::dvec3& v) {
                    const bool finite = std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
                    return finite && std::abs(std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) - 5) < 1e-9;
                };
                bad += !on_wall(seen);
                if (std::abs(x) > 5 || std::abs(y) > 5) continue;  // the formula is for points of the room
                const glm::dvec3 p(x, y, 1), far = glm::max((5.0 - p) / d, (-5.0 - p) / d);
                bad_printed += !on_wall(p + std::min({far.x, far.y, far.z}) * d);
            }
    test::hard_case(
        {"21",
         "box projection with components of zero, on walls, outside; naive: as printed, in the room and on its walls",
         "of 400 rays off the walls", 0, static_cast<double>(bad), static_cast<double>(bad_printed)});
    EXPECT_EQ(box_direction({1, 1, 1}, {0, 0, 0}, room), glm::dvec3(0));
}

// Rays from a camera at distance 3 that a ball of radius 1 in the room's middle mirrors, over the disc it covers.
struct Deviation {
    double mean = 0, largest = 0;
};
template <class F>
Deviation over_ball(double radius, const glm::dvec3& centre, double eye, F look) {
    Deviation error;
    int count = 0;
    constexpr int size = 220;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double extent = 1.3 * radius / eye;
            const Ray ray{{centre.x, centre.y, centre.z + eye},
                          *unit({extent * (2.0 * x / size - 1), extent * (2.0 * y / size - 1), -1.0})};
            const auto crossing = cross_sphere(ray, centre, radius);
            if (!crossing) continue;
            const glm::dvec3 p = ray.at(crossing->enter), r = *mirror(ray.direction, p - centre);
            const glm::dvec3 truth = *room_hit({p, r}, room.half);
            const double degrees = angle_between(look(p, r), truth) * 180 / pi;
            error.mean += degrees;
            error.largest = std::max(error.largest, degrees);
            ++count;
        }
    error.mean /= count;
    return error;
}

TEST(LocalityLadder, AnInfiniteMapIsSixDegreesOff) {
    const auto infinite = [](const glm::dvec3&, const glm::dvec3& r) { return r; };
    EXPECT_NEAR(over_ball(1, {0, 0, 0}, 3, infinite).mean / 6.49, 1, 0.03);
    EXPECT_NEAR(over_ball(1, {0, 0, 0}, 3, infinite).largest / 10.2, 1, 0.03);
    EXPECT_NEAR(over_ball(1, {0, 0, 0}, 4, infinite).mean / 6.41, 1, 0.03);
    EXPECT_NEAR(over_ball(2, {0, 0, 0}, 4.5, infinite).mean / 13.4, 1, 0.03);
}

TEST(LocalityLadder, DistanceImpostorsConverge) {
    const auto impostor = [](int k) {
        return [k](const glm::dvec3& p, const glm::dvec3& r) {
            return impostor_direction(p, r, k, [](const glm::dvec3& d) { return wall_distance(d, room.half); });
        };
    };
    const double expected[] = {0.695, 0.034, 0.002};
    for (int k = 0; k < 3; ++k)
        EXPECT_NEAR(over_ball(1, {0, 0, 0}, 3, impostor(k)).mean / expected[k], 1, k == 2 ? 0.3 : 0.1) << k;
    EXPECT_LT(over_ball(1, {0, 0, 0}, 3, impostor(4)).largest, 1e-3);
    EXPECT_EQ(over_ball(1, {0, 0, 0}, 3, impostor(8)).mean, over_ball(1, {0, 0, 0}, 3, impostor(1000)).mean);
}

// Two wrong things may cancel: of a glass ball in a room the surface alone, seen infinitely far, is nearer to the truth
// than the surface alone in its box; with the way out of the glass the box is exact.
TEST(LocalityLadder, TheBoxNeedsTheWayOutOfTheGlass) {
    double infinite = 0, entry = 0, through = 0;
    int count = 0;
    constexpr int size = 200;
    for (int i = 0; i < size * size; ++i) {
        const double x = 2.0 * (i % size) / size - 1, y = 2.0 * (i / size) / size - 1;
        const Ray ray{{0, 0, 3}, *unit({0.36 * x, 0.36 * y, -1.0})};
        const auto crossing = cross_sphere(ray, {0, 0, 0}, 1);
        if (!crossing) continue;
        const glm::dvec3 p = ray.at(crossing->enter), inside = meet(ray.direction, p, 1, 1.5)->transmitted;
        const glm::dvec3 exit = p - 2 * glm::dot(p, inside) * inside, out = meet(inside, exit, 1, 1.5)->transmitted;
        const glm::dvec3 truth = *room_hit({exit, out}, room.half);
        infinite += angle_between(inside, truth);
        entry += angle_between(box_direction(p, inside, room), truth);
        through += angle_between(box_direction(exit, leave_sphere(ray.direction, inside), room), truth);
        ++count;
    }
    const double degrees = 180 / pi / count;
    EXPECT_NEAR(infinite * degrees, 11.7, 0.3);
    EXPECT_NEAR(entry * degrees, 16.9, 0.3);
    test::hard_case({"A24",
                     "box projection of a glass ball: from where the light leaves it; naive: from where it enters",
                     "degrees in the mean", 1e-6, through * degrees, entry * degrees});
}

TEST(LocalityLadder, TheBoxIsExact) {
    const auto box = [](const glm::dvec3& p, const glm::dvec3& r) { return box_direction(p, r, room); };
    EXPECT_LT(over_ball(1, {0, 0, 0}, 3, box).largest, 1e-10);
    EXPECT_LT(over_ball(1, {3, 0, 0}, 3, box).largest, 1e-10);
}

}  // namespace
}  // namespace snell::optics
