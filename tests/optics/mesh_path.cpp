#include "tests/oracle/optics/mesh_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/optics/meshes.h"

namespace snell::optics {
namespace {

// Rays from a plane at z = 5 down, spread over a square, not along any edge of the mesh.
std::vector<Ray> rain(int side, double half) {
    std::vector<Ray> out;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            out.push_back({{half * ((2 * i + 1.0137) / side - 1), half * ((2 * k + 1.0071) / side - 1), 5},
                           {0.0123, -0.0234, -1}});
    return out;
}

double sum(const MeshLight& light) {
    double total = light.inside;
    for (const MeshExit& exit : light.exits) total += exit.energy;
    return total;
}

// With interpolated normals only the points differ from the ball's; their error falls with the square of the size of
// a triangle, and so must the direction's.
TEST(MeshPath, ApproachesTheClosedFormOfTheBall) {
    const auto error = [](std::uint32_t n, bool curved, std::size_t exit) {
        const Triangles ball = ball_mesh(n, n);
        const MeshTracer mesh(ball.positions, ball.indices);
        double total = 0;
        int count = 0;
        for (const Ray& ray : rain(24, 0.6)) {
            const auto truth =
                through_sphere(ray.direction, ray.at(cross_sphere(ray, glm::dvec3(0), 1)->enter), 1, 1.5);
            const auto light =
                through_mesh(mesh, ray, 1, 1.5, curved ? MeshNormals{ball.positions, ball.indices} : MeshNormals{});
            // At a facet near the rim a ray inside may be mirrored totally.
            if (!curved && light.exits.size() <= exit) continue;
            EXPECT_GT(light.exits.size(), exit);
            if (light.exits.size() <= exit) continue;
            total += angle_between(light.exits[exit].direction, truth.exits[exit].direction);
            if (curved) {
                EXPECT_NEAR(light.exits[exit].energy, truth.exits[exit].energy, 15.0 / (n * n));
            }
            EXPECT_LT(glm::length(light.exits[exit].position - truth.exits[exit].normal), 30.0 / n);
            ++count;
        }
        return total / count;
    };
    EXPECT_NEAR(glm::degrees(error(60, true, 1)), 0.03, 0.006);
    EXPECT_NEAR(glm::degrees(error(60, false, 1)), 1.13, 0.2);
    for (std::size_t exit : {0U, 1U, 2U}) {
        EXPECT_NEAR(error(50, true, exit) / error(150, true, exit), 9, 2.5) << exit;
        EXPECT_LT(error(150, true, exit), 1e-3) << exit;
        EXPECT_NEAR(error(50, false, exit) / error(150, false, exit), 3, 0.6) << exit;
    }
}

TEST(MeshPath, ASlabLetsLightOutAsItCame) {
    const Triangles slab = box_mesh({50, 50, 0.2});
    const MeshTracer mesh(slab.positions, slab.indices);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 500; ++i) {
        const Ray ray{{any(random), any(random), 2}, {3 * any(random), 3 * any(random), -1}};
        const auto light = through_mesh(mesh, ray, 1, 1.5);
        ASSERT_GE(light.exits.size(), 3U);
        EXPECT_LT(angle_between(light.exits[1].direction, ray.direction), 1e-14);
        EXPECT_LT(angle_between(light.exits[0].direction, light.exits[2].direction), 1e-14);
        const double f = light.exits[0].energy;
        EXPECT_NEAR(light.exits[1].energy, (1 - f) * (1 - f), 1e-12);
        EXPECT_NEAR(light.exits[2].energy, (1 - f) * (1 - f) * f, 1e-12);
    }
}

// The least angle by which a prism of apex A turns light: n = sin((A + D) / 2) / sin(A / 2).
TEST(MeshPath, APrismHasItsMinimumDeviation) {
    const double apex = pi / 3, n = 1.5168, high = std::sqrt(3.0) / 2;
    const Triangles prism = prism_mesh({{-0.5, 0}, {0.5, 0}, {0, high}}, 3);
    const MeshTracer mesh(prism.positions, prism.indices);
    double least = 10;
    for (double incident = 0.5; incident < 1.3; incident += 0.0005) {
        // Toward the middle of the left side, whose outward normal is (-cos 30°, sin 30°).
        const glm::dvec3 normal(-std::cos(pi / 6), std::sin(pi / 6), 0), along(-std::sin(pi / 6), -std::cos(pi / 6), 0);
        const glm::dvec3 back = std::cos(incident) * normal + std::sin(incident) * along;
        const glm::dvec3 at(-0.25, high / 2, 0.01);
        const auto light = through_mesh(mesh, {at + 3.0 * back, -back}, 1, n);
        for (const MeshExit& exit : light.exits)
            if (exit.through && exit.energy > 0.5) least = std::min(least, angle_between(exit.direction, -back));
    }
    const double deviation = 2 * std::asin(n * std::sin(apex / 2)) - apex;
    EXPECT_NEAR(least, deviation, 1e-6);
}

// Hard cases 11 and 15, for a mesh that light meets again after it came out, and for one that holds it.
TEST(MeshPath, AllLightIsAccountedFor) {
    const Triangles torus = torus_mesh(40, 24, 0.4), box = box_mesh({1, 0.9, 0.8}), ball = ball_mesh(30, 20);
    for (const Triangles* shape : {&torus, &box, &ball}) {
        const MeshTracer mesh(shape->positions, shape->indices);
        for (double n : {1.0003, 1.5, 2.42, 1 / 1.5}) {
            double left = 0;
            int met = 0;
            for (const Ray& ray : rain(30, 1.6)) {
                const auto light = through_mesh(mesh, ray, 1, n);
                EXPECT_NEAR(sum(light), 1, 1e-12);
                EXPECT_LE(light.triangles.size(), 2U * series_limit + 2);
                for (const MeshExit& exit : light.exits) {
                    EXPECT_TRUE(exit.closed);
                    EXPECT_GE(exit.energy, 0.0);
                    EXPECT_NEAR(glm::length(exit.direction), 1, 1e-14);
                }
                left += light.inside;
                met += light.triangles.empty() ? 0 : 1;
            }
            EXPECT_GT(met, 150);
            if (n == 1.0003) {
                EXPECT_LT(left / met, 2e-3);
            }
        }
    }
}

// Light that goes back along its last ray comes out where it came from, with the same share: T(a → b) = T(b → a).
TEST(MeshPath, WaysBackAreTheSame) {
    const Triangles torus = torus_mesh(40, 24, 0.4);
    const MeshTracer mesh(torus.positions, torus.indices);
    int compared = 0;
    for (const Ray& ray : rain(20, 1.5)) {
        const auto light = through_mesh(mesh, ray, 1, 1.5);
        for (const MeshExit& exit : light.exits) {
            if (!exit.through || exit.energy < 0.05) continue;
            const Ray back{exit.position + 9.0 * exit.direction, -exit.direction};
            double best = 10, energy = 0;
            for (const MeshExit& other : through_mesh(mesh, back, 1, 1.5).exits)
                if (angle_between(other.direction, -ray.direction) < best)
                    best = angle_between(other.direction, -ray.direction), energy = other.energy;
            EXPECT_LT(best, 1e-9);
            EXPECT_NEAR(energy, exit.energy, 1e-9);
            ++compared;
        }
    }
    EXPECT_GT(compared, 100);
}

// The same of the ball's closed form, exit by exit.
TEST(MeshPath, WaysBackThroughABallAreTheSame) {
    int compared = 0;
    for (double n : {1.33, 1.5, 2.42})
        for (double b = 0.05; b < 1; b += 0.05) {
            const glm::dvec3 normal(b, 0, std::sqrt(1 - b * b)), along(0, 0, -1);
            for (const Exit& exit : through_sphere(along, normal, 1, n).exits) {
                if (exit.order == 0) continue;
                const auto back = through_sphere(-exit.direction, exit.normal, 1, n);
                const auto same = static_cast<std::size_t>(exit.order);
                ASSERT_GT(back.exits.size(), same);
                EXPECT_LT(angle_between(back.exits[same].direction, -along), 1e-12);
                EXPECT_LT(glm::length(back.exits[same].normal - normal), 1e-12);
                EXPECT_NEAR(back.exits[same].energy, exit.energy, 1e-13);
                ++compared;
            }
        }
    EXPECT_GT(compared, 100);
}

TEST(MeshPath, MeetsATorusAgain) {
    const Triangles torus = torus_mesh(60, 40, 0.3);
    const MeshTracer mesh(torus.positions, torus.indices);
    // Along x through both sides of the ring: four interfaces, each nearly at a right angle.
    const auto light = through_mesh(mesh, {{5, 0.001, 0.002}, {-1, 0, 0}}, 1, 1.5);
    ASSERT_GE(light.triangles.size(), 4U);
    double straight = 0;
    for (const MeshExit& exit : light.exits)
        if (exit.direction.x < 0 && exit.position.x < -1.2) straight = std::max(straight, exit.energy);
    EXPECT_NEAR(straight, std::pow(0.96, 4), 1e-3);
}

TEST(MeshPath, BeginsInsideAndPassesBy) {
    const Triangles box = box_mesh({1, 1, 1});
    const MeshTracer mesh(box.positions, box.indices);
    const auto inside = through_mesh(mesh, {{0.1, 0.2, 0}, {0, 0, 1}}, 1, 1.5);
    ASSERT_FALSE(inside.exits.empty());
    EXPECT_NEAR(inside.exits[0].energy, 0.96, 1e-12);
    EXPECT_TRUE(inside.exits[0].through);
    const auto past = through_mesh(mesh, {{4, 0, 0}, {0, 0, 1}}, 1, 1.5);
    ASSERT_EQ(past.exits.size(), 1U);
    EXPECT_EQ(past.exits[0].energy, 1.0);
    EXPECT_EQ(past.exits[0].direction, glm::dvec3(0, 0, 1));
    EXPECT_TRUE(through_mesh(mesh, {{4, 0, 0}, {0, 0, 0}}, 1, 1.5).exits.empty());
    EXPECT_TRUE(through_mesh(mesh, {{4, 0, 0}, {0, 0, 1}}, 1, -1.5).exits.empty());
}

// A hole: light inside that meets no surface goes on as it was.
TEST(MeshPath, AHoleLetsLightOut) {
    Triangles box = box_mesh({1, 1, 1});
    std::vector<std::uint32_t> open;
    for (std::size_t i = 0; i < box.indices.size(); i += 3) {
        bool bottom = true;
        for (std::size_t k = 0; k < 3; ++k) bottom = bottom && box.positions[box.indices[i + k]].z < 0;
        for (std::size_t k = 0; k < 3 && !bottom; ++k) open.push_back(box.indices[i + k]);
    }
    const MeshTracer mesh(box.positions, open);
    EXPECT_EQ(mesh.triangles(), 10U);
    const auto light = through_mesh(mesh, {{0.1, 0.2, 3}, {0, 0, -1}}, 1, 1.5);
    ASSERT_EQ(light.exits.size(), 2U);
    EXPECT_FALSE(light.exits[1].closed);
    EXPECT_NEAR(light.exits[1].energy, 0.96, 1e-12);
    EXPECT_NEAR(sum(light), 1, 1e-12);
}

// Next to edges and corners, where a path meets two faces within a rounding of each other.
TEST(MeshPath, EdgesAndCornersDoNotLeak) {
    const Triangles box = box_mesh({1, 0.9, 0.8});
    const MeshTracer mesh(box.positions, box.indices);
    int open = 0;
    for (const glm::dvec3& corner : box.positions)
        for (int axis = 0; axis < 3; ++axis)
            for (double t : {0.0, 1e-16, 1e-15, 1e-9, 0.3}) {
                glm::dvec3 toward = corner;
                toward[axis] *= 1 - 2 * t;
                for (const glm::dvec3& from : {glm::dvec3(3, 4, 5), glm::dvec3(-4, 1, 3), glm::dvec3(0.1, -5, 0.3)}) {
                    const auto light = through_mesh(mesh, {from, toward - from}, 1, 1.5);
                    EXPECT_NEAR(sum(light), 1, 1e-12);
                    for (const MeshExit& exit : light.exits) open += !exit.closed;
                }
            }
    EXPECT_EQ(open, 0);
}

}  // namespace
}  // namespace snell::optics
