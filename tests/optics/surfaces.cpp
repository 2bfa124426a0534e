// What the oracle stands on: amplitudes, complex arithmetic, chords, closed forms, and numbers printed elsewhere than
// its formulas. The laws of light are judged in shaders, which agree with the oracle (tests/library).
#include "tests/oracle/optics/color.h"
#include "tests/oracle/optics/fresnel.h"
#include "tests/oracle/optics/glass.h"
#include "tests/oracle/optics/irradiance.h"
#include "tests/oracle/optics/mesh_path.h"
#include "tests/oracle/optics/refraction.h"
#include "tests/std.h"

namespace snell::optics {
namespace {

using std::numbers::pi;

constexpr double indices[] = {1.0003, 1.31, 1.33, 1.5, 1.52, 2.42, 4.0};

// The transmitted part, from the amplitudes of Fresnel's equations: T = (n2 cos t) / (n1 cos i) · t².
TEST(Reflectance, WhatIsNotReflectedIsTransmittedAndBothWaysAreAlike) {
    for (const double n : indices)
        for (int i = 0; i < 90; ++i) {
            const double c = std::cos(i * pi / 180), t = std::sqrt(transmitted_cos2(c, 1, n)), beam = n * t / c;
            const double s = 2 * c / (c + n * t), p = 2 * c / (n * c + t);
            const Polarised r = fresnel_polarised(c, 1, n);
            EXPECT_NEAR(r.s + beam * s * s, 1.0, 1e-12) << n << " at " << i;
            EXPECT_NEAR(r.p + beam * p * p, 1.0, 1e-12) << n << " at " << i;
            EXPECT_NEAR(r.mean(), fresnel(t, n, 1), 1e-11) << n << " at " << i;
        }
}

// Fresnel's amplitudes in complex arithmetic.
TEST(Reflectance, OfMetalsAgreesWithComplexArithmetic) {
    const auto by_complex_numbers = [](double c, double n1, std::complex<double> n2) {
        const std::complex<double> s2 = n1 * n1 * (1 - c * c), t = std::sqrt(n2 * n2 - s2) / n2;
        return Polarised{std::norm((n1 * c - n2 * t) / (n1 * c + n2 * t)),
                         std::norm((n2 * c - n1 * t) / (n2 * c + n1 * t))};
    };
    for (const double n1 : {1.0, 1.33, 2.42})
        for (const double eta : {0.04, 0.43, 1.0, 1.5, 3.0})
            for (double c = 0.01; c <= 1; c += 0.01) {
                for (const double k : {0.3, 1.9, 4.5, 12.0}) {
                    const Polarised mine = fresnel_conductor_polarised(c, n1, eta, k);
                    const Polarised truth = by_complex_numbers(c, n1, {eta, k});
                    EXPECT_NEAR(mine.s, truth.s, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                    EXPECT_NEAR(mine.p, truth.p, 1e-13) << n1 << " " << eta << " " << k << " " << c;
                }
                EXPECT_NEAR(fresnel_conductor(c, n1, eta, 0), fresnel(c, n1, eta), 1e-7) << "without absorption";
            }
    EXPECT_NEAR(lazanyi(1.0 / 7, fresnel_conductor(1, 1, .96, 6.69), lazanyi_depth(.96, 6.69)),
                fresnel_conductor(1.0 / 7, 1, .96, 6.69), 1e-12)
        << "the dip is where absorption makes it";
}

// ---- What the oracle has from the literature, against numbers that are printed elsewhere than its formulas.

// CIE 1931 2°, the printed table at five wavelengths; the fit is within .03.
TEST(Tables, MatchingFunctions) {
    const double table[][4] = {{450, 0.3362, 0.0380, 1.7721},
                               {500, 0.0049, 0.3230, 0.2720},
                               {550, 0.4334, 0.9950, 0.0087},
                               {600, 1.0622, 0.6310, 0.0008},
                               {650, 0.2835, 0.1070, 0.0000}};
    for (const auto& [nm, x, y, z] : table)
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(cie_1931(nm)[i], (glm::dvec3{x, y, z})[i], 0.03) << nm;
    EXPECT_LT(glm::length(xyz_to_linear_srgb({0.95047, 1.0, 1.08883}) - glm::dvec3(1)), 1e-4) << "white is white";
    for (int count : {3, 4, 8, 64, 500}) {
        glm::dvec3 sum(0);
        for (const Band& band : spectral_bands(count)) sum += band.rgb;
        EXPECT_LT(glm::length(sum - glm::dvec3(1)), 1e-12) << count;
    }
}

// The index at the d line that tables of minerals and catalogues of glass print, and the Abbe number.
TEST(Tables, Glass) {
    const struct {
        const char* name;
        double n_d, within, abbe;
    } printed[] = {
        {"air", 1.000277, 1e-6, 89.3},    {"ice", 1.3098, 4e-4, 54.6},      {"water", 1.3330, 5e-4, 55.8},
        {"Pyrex", 1.4714, 1e-6, 65.4},    {"quartz", 1.5443, 2e-4, 69.7},   {"window glass", 1.5234, 2e-4, 64.0},
        {"BK7", 1.51680, 1e-5, 64.17},    {"SF11", 1.78472, 1e-5, 25.68},   {"cubic zirconia", 2.1585, 1e-3, 33.5},
        {"diamond", 2.41749, 1e-4, 55.3}, {"moissanite", 2.690, 2e-3, 23.9}};
    for (const auto& p : printed) {
        const Glass* glass = find_glass(p.name);
        ASSERT_TRUE(glass) << p.name;
        EXPECT_NEAR(glass->index_d(), p.n_d, p.within) << p.name;
        EXPECT_NEAR(glass->abbe(), p.abbe, 0.1) << p.name;
    }
    EXPECT_NEAR(find_glass("ice")->index(400), 1.3194, 4e-4) << "Warren and Brandt 2008";
    EXPECT_NEAR(find_glass("ice")->index(750), 1.3059, 4e-4) << "Warren and Brandt 2008";
}

TEST(Tables, MetalsAreStraightBetweenMeasurements) {
    const Metal& gold = metals()[0];
    EXPECT_EQ(gold.name, "gold");
    EXPECT_EQ(gold.index(548.6).eta, 0.43);
    EXPECT_EQ(gold.index(548.6).k, 2.455);
    EXPECT_NEAR(gold.index((548.6 + 582.1) / 2).k, (2.455 + 2.863) / 2, 1e-12);
    EXPECT_EQ(gold.index(100).k, 1.952);
    EXPECT_EQ(gold.index(5000).k, 4.542);
}

TEST(Tables, SolidAnglesSumToTheSphere) {
    for (int size : {1, 2, 7, 64}) {
        double sum = 0;
        for (int row = 0; row < size; ++row)
            for (int column = 0; column < size; ++column) sum += texel_solid_angle(column, row, size);
        EXPECT_NEAR(6 * sum, 4 * std::numbers::pi, 1e-12) << size;
    }
    const Radiance linear = [](const glm::dvec3& d) { return glm::dvec3(1 + d.x); };
    EXPECT_NEAR(irradiance(linear, {.6, 0, .8}, 64).x, 1 + 2. / 3 * .6, 1e-3) << "Ramamoorthi and Hanrahan's A1";
}

// ---- The ways of light through balls and meshes: two ways of finding them.

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

// Rays from a plane at z = 5 down, spread over a square, not along any edge of the mesh.
std::vector<Ray> rain(int side, double half) {
    std::vector<Ray> out;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k)
            out.push_back({{half * ((2 * i + 1.0137) / side - 1), half * ((2 * k + 1.0071) / side - 1), 5},
                           {0.0123, -0.0234, -1}});
    return out;
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

}  // namespace
}  // namespace snell::optics
