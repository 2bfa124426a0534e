#include "tests/oracle/optics/ray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace snell::optics {
namespace {

TEST(CrossSphere, FindsBothEndsOfTheChord) {
    const Ray ray{{0, 0.6, 5}, {0, 0, -2}};
    const auto c = cross_sphere(ray, {0, 0, 0}, 1.0);
    ASSERT_TRUE(c);
    EXPECT_NEAR(glm::length(ray.at(c->enter) - glm::dvec3(0, 0.6, 0.8)), 0, 1e-15);
    EXPECT_NEAR(glm::length(ray.at(c->leave) - glm::dvec3(0, 0.6, -0.8)), 0, 1e-15);
    EXPECT_FALSE(cross_sphere({{0, 1.0001, 5}, {0, 0, -1}}, {0, 0, 0}, 1.0));
}

TEST(CrossSphere, FromFarAwayIsAsExactAsFromNear) {
    for (double distance : {10.0, 1e4, 1e8}) {
        const Ray ray{{0.6, 0, distance}, {0, 0, -1}};
        const auto c = cross_sphere(ray, {0, 0, 0}, 1.0);
        ASSERT_TRUE(c);
        EXPECT_NEAR(c->leave - c->enter, 1.6, 1e-7);
    }
}

TEST(CrossSphere, FromInsideStartsBehind) {
    const auto c = cross_sphere({{0, 0, 0}, {1, 0, 0}}, {0, 0, 0}, 2.0);
    ASSERT_TRUE(c);
    EXPECT_EQ(c->enter, -2);
    EXPECT_EQ(c->leave, 2);
}

TEST(CrossBox, AlongAnAxisAndInAPlaneOfTheBox) {
    const auto c = cross_box({{-3, 0, 0}, {1, 0, 0}}, glm::dvec3(-1), glm::dvec3(1));
    ASSERT_TRUE(c);
    EXPECT_EQ(c->enter, 2);
    EXPECT_EQ(c->leave, 4);
    EXPECT_TRUE(cross_box({{-3, 1, 0}, {1, 0, 0}}, glm::dvec3(-1), glm::dvec3(1)));
    EXPECT_FALSE(cross_box({{-3, 1.0001, 0}, {1, 0, 0}}, glm::dvec3(-1), glm::dvec3(1)));
    EXPECT_FALSE(cross_box({{-3, 3, 0}, {1, 0.1, 0}}, glm::dvec3(-1), glm::dvec3(1)));
}

TEST(CrossPlane, ParallelIsNever) {
    EXPECT_FALSE(cross_plane({{0, 1, 0}, {1, 0, 0}}, {0, 1, 0}, 0));
    EXPECT_EQ(*cross_plane({{0, 1, 0}, {1, -0.5, 0}}, {0, 1, 0}, 0), 2);
}

TEST(RoomHit, LiesOnAWallAndOnTheRay) {
    for (int i = 0; i < 200; ++i) {
        const Ray ray{{std::sin(1.0 * i), 2 * std::sin(2.3 * i), std::cos(1.7 * i)},
                      {std::cos(0.9 * i), std::sin(1.1 * i), std::cos(2.9 * i + 1)}};
        const auto p = room_hit(ray, glm::dvec3(5));
        ASSERT_TRUE(p);
        EXPECT_NEAR(std::max({std::abs(p->x), std::abs(p->y), std::abs(p->z)}), 5, 1e-12);
        EXPECT_NEAR(glm::length(glm::cross(*p - ray.origin, ray.direction)), 0, 1e-12);
        EXPECT_GT(glm::dot(*p - ray.origin, ray.direction), 0);
    }
    EXPECT_FALSE(room_hit({{6, 0, 0}, {1, 0, 0}}, glm::dvec3(5)));
}

TEST(Camera, MiddleLooksAtTheCentreAndTheTopEdgeIsHalfTheAngleUp) {
    const Camera camera{{1, 2, 3}, {4, -1, 0}, {0, 1, 0}, 50};
    const Ray middle = camera_ray(camera, 32, 24, 64, 48), top = camera_ray(camera, 32, 0, 64, 48);
    EXPECT_NEAR(glm::length(middle.direction - glm::normalize(camera.centre - camera.eye)), 0, 1e-15);
    EXPECT_NEAR(glm::dot(middle.direction, top.direction), std::cos(glm::radians(25.0)), 1e-15);
    EXPECT_GT(top.direction.y, middle.direction.y);
}

TEST(Camera, NinetyDegreesSeeExactlyOneWall) {
    const Camera camera{{0, 0, 0}, {0, 0, -1}, {0, 1, 0}, 90};
    const Ray corner = camera_ray(camera, 0, 0, 100, 100);
    const auto p = room_hit(corner, glm::dvec3(5));
    EXPECT_NEAR(glm::length(*p - glm::dvec3(-5, 5, -5)), 0, 1e-12);
}

TEST(Camera, ProjectIsTheInverseOfTheRay) {
    const Camera camera{{1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 70};
    const Ray ray = camera_ray(camera, 13.25, 40.5, 80, 60);
    const auto pixel = project(camera, ray.at(4.2), 80, 60);
    ASSERT_TRUE(pixel);
    EXPECT_NEAR(pixel->x, 13.25, 1e-12);
    EXPECT_NEAR(pixel->y, 40.5, 1e-12);
    EXPECT_FALSE(project(camera, ray.at(-1), 80, 60));
}

}  // namespace
}  // namespace snell::optics
