// The ways of light through balls and meshes, by which the oracle is judged: two ways of finding them, and the energy.
#include "tests/oracle/optics/mesh_path.h"
#include "tests/std.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

struct Triangles {
    std::vector<glm::dvec3> positions;
    std::vector<std::uint32_t> indices;
};

// Of radius 1. Its positions are its normals.
Triangles ball_mesh(std::uint32_t slices, std::uint32_t stacks) {
    Triangles out;
    for (std::uint32_t j = 0; j <= stacks; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const double phi = 2 * pi * i / slices, theta = pi * j / stacks;
            const double ring = j == stacks ? 0 : std::sin(theta);  // a pole is one point
            out.positions.emplace_back(ring * std::cos(phi), std::cos(theta), -ring * std::sin(phi));
        }
    for (std::uint32_t j = 0; j < stacks; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const std::uint32_t a = j * slices + i, b = j * slices + (i + 1) % slices;
            for (std::uint32_t v : {a, a + slices, b, b, a + slices, b + slices}) out.indices.push_back(v);
        }
    return out;
}

// Around y, with radius 1 to the middle of a tube of radius .4.
Triangles torus_mesh() {
    constexpr std::uint32_t around = 40, along = 24;
    Triangles out;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < along; ++j) {
            const double phi = 2 * pi * i / around, theta = 2 * pi * j / along, r = 1 + .4 * std::cos(theta);
            out.positions.emplace_back(r * std::cos(phi), .4 * std::sin(theta), -r * std::sin(phi));
            const std::uint32_t k = (i + 1) % around, l = (j + 1) % along;
            const std::uint32_t a = i * along + j, b = k * along + j, c = k * along + l, d = i * along + l;
            for (std::uint32_t v : {a, b, c, a, c, d}) out.indices.push_back(v);
        }
    return out;
}

Triangles box_mesh(const glm::dvec3& half) {
    Triangles out{{}, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                       2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5}};
    for (int i = 0; i < 8; ++i) out.positions.push_back(half * (2. * glm::dvec3(i & 1, i >> 1 & 1, i >> 2) - 1.));
    return out;
}

// Rays from a plane at z = 5 down, spread over a square, not along any edge of the mesh.
std::vector<Ray> rain(int side, double half) {
    std::vector<Ray> out;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            out.push_back({{half * ((2 * i + 1.0137) / side - 1), half * ((2 * k + 1.0071) / side - 1), 5},
                           {0.0123, -0.0234, -1}});
    return out;
}

TEST(MeshTracer, FindsWhatTryingAllFinds) {
    const Triangles ball = ball_mesh(24, 16);
    const MeshTracer mesh(ball.positions, ball.indices);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const Ray ray{glm::dvec3(any(random), any(random), any(random)) * 3.0,
                      glm::dvec3(any(random), any(random), any(random)) * std::exp(4 * any(random))};
        const auto fast = mesh.nearest(ray), slow = mesh.nearest_by_all(ray);
        ASSERT_EQ(fast.has_value(), slow.has_value());
        if (!fast) continue;
        ++hits;
        EXPECT_EQ(fast->distance, slow->distance);
        EXPECT_LT(glm::length(mesh.point(fast->triangle, fast->weights) - ray.at(fast->distance)), 1e-12);
    }
    EXPECT_GT(hits, 200);
}

// A ray along -z that meets the ball of radius 1 at distance b from its axis.
SphereLight through_ball(double b, double n, int orders = series_limit) {
    return through_sphere({0, 0, -1}, {b, 0, std::sqrt((1 - b) * (1 + b))}, 1, n, orders);
}

// The path as geometry has it: chords that end on the ball, refracted or mirrored at each end.
TEST(ThroughSphere, FollowsTheChords) {
    for (const double n : {1.31, 1.5, 2.42})
        for (const double b : {0.0, 0.01, 0.3, 0.6, 0.9, 0.99}) {
            glm::dvec3 at(b, 0, std::sqrt((1 - b) * (1 + b))), inside = meet({0, 0, -1}, at, 1, n)->transmitted;
            EXPECT_LT(angle_between(through_ball(b, n).exits.at(1).direction, leave_sphere({0, 0, -1}, inside)), 1e-14);
            for (const Exit& exit : through_ball(b, n, 6).exits) {
                if (exit.order == 0) continue;
                at = *unit(at - 2.0 * glm::dot(at, inside) * inside);
                const auto met = meet(inside, at, 1, n);
                EXPECT_EQ(met->side, Side::inside);
                EXPECT_LT(angle_between(exit.direction, met->transmitted), 2e-7) << n << " " << b << " " << exit.order;
                inside = met->reflected;
            }
        }
}

// What has come out and what is still inside is all there was, and the series ends.
TEST(ThroughSphere, LosesNoLight) {
    for (const double n : {1.0003, 1.33, 1.5, 2.42, 0.7})
        for (const double b : {0.0, 0.5, 0.69, 0.9, 0.999, 0.9999999})
            for (const int orders : {0, 1, 2, 5, 32, 1000000}) {
                const auto light = through_ball(b, n, orders);
                double sum = light.inside;
                for (const Exit& exit : light.exits) sum += exit.energy;
                EXPECT_NEAR(sum, 1.0, 1e-12) << n << " " << b << " " << orders;
                EXPECT_LE(light.exits.size(), 1U + series_limit);
                EXPECT_TRUE(orders < 1000 || light.exits.size() == 1U + series_limit || light.inside < series_end);
            }
    EXPECT_TRUE(through_sphere({0, 0, 1}, {0, 0, 1}, 1, 1.5).exits.empty()) << "from inside";
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

// All light is accounted for, and what goes back along its last ray comes out where it came from, with the same share:
// T(a → b) = T(b → a).
TEST(MeshPath, LosesNoLightAndWaysBackAreTheSame) {
    const Triangles torus = torus_mesh();
    const MeshTracer mesh(torus.positions, torus.indices);
    int compared = 0;
    for (const double n : {1.0003, 1.5, 2.42, 1 / 1.5})
        for (const Ray& ray : rain(20, 1.5)) {
            const auto light = through_mesh(mesh, ray, 1, n);
            EXPECT_LE(light.triangles.size(), 2U * series_limit + 2);
            double sum = light.inside;
            for (const MeshExit& exit : light.exits) {
                sum += exit.energy;
                EXPECT_TRUE(exit.closed);
                if (n != 1.5 || !exit.through || exit.energy < 0.05) continue;
                const Ray back{exit.position + 9.0 * exit.direction, -exit.direction};
                double best = 10, energy = 0;
                for (const MeshExit& other : through_mesh(mesh, back, 1, n).exits)
                    if (angle_between(other.direction, -ray.direction) < best)
                        best = angle_between(other.direction, -ray.direction), energy = other.energy;
                EXPECT_LT(best, 1e-9);
                EXPECT_NEAR(energy, exit.energy, 1e-9);
                ++compared;
            }
            EXPECT_NEAR(sum, 1, 1e-12);
        }
    EXPECT_GT(compared, 100);
}

// What came in through one side of a slab goes out through the other, however flat.
TEST(MeshPath, ASlabLetsLightOutAsItCame) {
    const Triangles slab = box_mesh({50, 50, .2});
    const MeshTracer mesh(slab.positions, slab.indices);
    for (const double n : {1.0003, 1.5, 2.42})
        for (double c = 1; c > 0.02; c *= 0.99) {
            const glm::dvec3 along(0.6 * std::sqrt((1 - c) * (1 + c)), 0.8 * std::sqrt((1 - c) * (1 + c)), -c);
            const auto light = through_mesh(mesh, {glm::dvec3(.1, .2, .2) - 9. * along, along}, 1, n);
            ASSERT_GE(light.exits.size(), 2U) << n << " " << c;
            EXPECT_TRUE(light.exits[1].through) << n << " " << c;
            EXPECT_LT(angle_between(light.exits[1].direction, along), 1e-13) << n << " " << c;
        }
}

// Next to edges and corners, where a path meets two faces within a rounding of each other.
TEST(MeshPath, EdgesAndCornersDoNotLeak) {
    const Triangles box = box_mesh({1, .9, .8});
    const MeshTracer mesh(box.positions, box.indices);
    for (const glm::dvec3& corner : box.positions)
        for (int axis = 0; axis < 3; ++axis)
            for (const double t : {0.0, 1e-16, 1e-15, 1e-9, 0.3}) {
                glm::dvec3 toward = corner;
                toward[axis] *= 1 - 2 * t;
                for (const glm::dvec3& from : {glm::dvec3(3, 4, 5), glm::dvec3(-4, 1, 3), glm::dvec3(0.1, -5, 0.3)})
                    for (const MeshExit& exit : through_mesh(mesh, {from, toward - from}, 1, 1.5).exits)
                        EXPECT_TRUE(exit.closed) << t;
            }
}

}  // namespace
}  // namespace snell::optics
