#include "tests/oracle/optics/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/optics/meshes.h"
#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

std::vector<Ray> rays(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(-1, 1);
    std::vector<Ray> out;
    for (int i = 0; i < count; ++i)
        out.push_back({glm::dvec3(any(random), any(random), any(random)) * 3.0,
                       glm::dvec3(any(random), any(random), any(random)) * std::exp(4 * any(random))});
    return out;
}

TEST(MeshTracer, FindsWhatTryingAllFinds) {
    const Triangles ball = ball_mesh(24, 16);
    const MeshTracer mesh(ball.positions, ball.indices);
    EXPECT_EQ(mesh.triangles(), 24U * 16 * 2);
    int hits = 0;
    for (const Ray& ray : rays(4000, 1)) {
        const auto fast = mesh.nearest(ray), slow = mesh.nearest_by_all(ray);
        ASSERT_EQ(fast.has_value(), slow.has_value());
        if (!fast) continue;
        ++hits;
        EXPECT_EQ(fast->distance, slow->distance);
    }
    EXPECT_GT(hits, 200);
}

TEST(MeshTracer, GivesThePointItMet) {
    const Triangles ball = ball_mesh(24, 16);
    const MeshTracer mesh(ball.positions, ball.indices);
    for (const Ray& ray : rays(1000, 2)) {
        const auto hit = mesh.nearest(ray);
        if (!hit) continue;
        glm::dvec3 point(0);
        for (int k = 0; k < 3; ++k)
            point += hit->weights[k] * ball.positions[ball.indices[hit->triangle * 3 + static_cast<std::size_t>(k)]];
        EXPECT_LT(glm::length(point - ray.at(hit->distance)), 1e-12);
        EXPECT_GE(std::min({hit->weights.x, hit->weights.y, hit->weights.z}), 0.0);
    }
}

// A finer ball is nearer to the true one: its error falls with the square of the number of slices.
TEST(MeshTracer, ApproachesTheAnalyticBall) {
    const auto error = [](std::uint32_t n) {
        const Triangles ball = ball_mesh(n, n);
        const MeshTracer mesh(ball.positions, ball.indices);
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 2000; ++i) {
            const double b = 0.7 * i / 2000.0;
            const Ray ray{{b, 0.31 * b, 5}, {0, 0, -1}};
            const auto hit = mesh.nearest(ray);
            const auto truth = cross_sphere(ray, glm::dvec3(0), 1);
            EXPECT_TRUE(hit.has_value());
            sum += std::abs(hit->distance - truth->enter);
            ++count;
        }
        return sum / count;
    };
    EXPECT_NEAR(error(30) / error(90), 9, 1.5);
}

// From the middle of a closed mesh every ray ends on it: exactly at its corners and along its edges too.
TEST(MeshTracer, LetsNothingSlipThrough) {
    const Triangles ball = ball_mesh(20, 14);
    const MeshTracer mesh(ball.positions, ball.indices);
    const glm::dvec3 origin(0.01, 0.02, 0.03);
    for (std::size_t i = 0; i + 2 < ball.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 a = ball.positions[ball.indices[i + k]], b = ball.positions[ball.indices[i + (k + 1) % 3]];
            for (double t : {0.0, 0.25, 0.5, 1 / 3.0}) {
                const auto hit = mesh.nearest({origin, glm::mix(a, b, t) - origin});
                ASSERT_TRUE(hit) << "triangle " << i / 3 << " edge " << k << " at " << t;
                EXPECT_NEAR(hit->distance, 1, 1e-9);
            }
        }
}

TEST(MeshTracer, StartsBehindWhatItWasToldToSkip) {
    const Triangles ball = ball_mesh(20, 14);
    const MeshTracer mesh(ball.positions, ball.indices);
    const Ray ray{{0.1, 0.2, 5}, {0, 0, -1}};
    const auto first = mesh.nearest(ray), second = mesh.nearest(ray, first->distance);
    ASSERT_TRUE(second);
    EXPECT_LT(ray.at(second->distance).z, 0);
    EXPECT_FALSE(mesh.nearest(ray, second->distance));
}

TEST(MeshTracer, BadTrianglesAreNeverMet) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nan, 0, 0}, {0, 0, 1}, {0, 0, 2}};
    const std::vector<std::uint32_t> indices = {0, 1, 99, 0, 1, 3, 4, 4, 5, 0, 1, 2, 7};
    const MeshTracer mesh(positions, indices);
    const auto hit = mesh.nearest({{0.2, 0.2, 3}, {0, 0, -1}});
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->triangle, 3U);
    EXPECT_EQ(mesh.face_normal(3), glm::dvec3(0, 0, 1));
    EXPECT_FALSE(mesh.nearest({{0.2, 0.2, 3}, {0, 0, 0}}));
    EXPECT_FALSE(mesh.nearest({{0.2, nan, 3}, {0, 0, -1}}));
    EXPECT_FALSE(MeshTracer({}, {}).nearest({{0.2, 0.2, 3}, {0, 0, -1}}));
}

}  // namespace
}  // namespace snell::optics
