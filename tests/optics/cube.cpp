#include "tests/oracle/optics/cube.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

// Faces whose texels are the colour of the direction they stand for: a map without seams.
struct Painted {
    std::array<std::vector<std::uint8_t>, 6> bytes;
    CubeTexels faces;
    explicit Painted(int size) {
        for (int face = 0; face < 6; ++face) {
            auto& out = bytes[static_cast<std::size_t>(face)];
            for (int row = 0; row < size; ++row)
                for (int column = 0; column < size; ++column) {
                    const glm::dvec3 d = *unit(cube_direction({face, (column + 0.5) / size, (row + 0.5) / size}));
                    for (int i = 0; i < 3; ++i)
                        out.push_back(static_cast<std::uint8_t>(std::lround(127.5 + 127.5 * d[i])));
                }
            faces[static_cast<std::size_t>(face)] = {size, size, 3, out};
        }
    }
};

TEST(CubePoint, AxesHitTheMiddleOfTheirFace) {
    const glm::dvec3 axes[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (int face = 0; face < 6; ++face) {
        const auto p = cube_point(axes[face] * 7.5);
        ASSERT_TRUE(p);
        EXPECT_EQ(p->face, face);
        EXPECT_EQ(p->s, 0.5);
        EXPECT_EQ(p->t, 0.5);
    }
}

// OpenGL 4.6 core, table 8.19, written out: sc and tc by face.
TEST(CubePoint, FollowsTheTableOfTheSpecification) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 5000; ++i) {
        const glm::dvec3 r(any(random), any(random), any(random));
        const double x = std::abs(r.x), y = std::abs(r.y), z = std::abs(r.z);
        int face;
        double sc, tc, ma;
        if (x > y && x > z)
            face = r.x > 0 ? 0 : 1, sc = r.x > 0 ? -r.z : r.z, tc = -r.y, ma = x;
        else if (y > z)
            face = r.y > 0 ? 2 : 3, sc = r.x, tc = r.y > 0 ? r.z : -r.z, ma = y;
        else
            face = r.z > 0 ? 4 : 5, sc = r.z > 0 ? r.x : -r.x, tc = -r.y, ma = z;
        const auto p = cube_point(r);
        ASSERT_TRUE(p);
        EXPECT_EQ(p->face, face);
        EXPECT_NEAR(p->s, (sc / ma + 1) / 2, 1e-14);
        EXPECT_NEAR(p->t, (tc / ma + 1) / 2, 1e-14);
    }
}

TEST(CubePoint, DirectionIsItsInverse) {
    for (int face = 0; face < 6; ++face)
        for (double s : {0.01, 0.3, 0.99})
            for (double t : {0.02, 0.5, 0.97}) {
                const auto p = cube_point(cube_direction({face, s, t}) * 0.01);
                ASSERT_TRUE(p);
                EXPECT_EQ(p->face, face);
                EXPECT_NEAR(p->s, s, 1e-14);
                EXPECT_NEAR(p->t, t, 1e-14);
            }
}

TEST(CubePoint, TiesGoToAFaceThatMeetsThere) {
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z) {
                const glm::dvec3 d(x, y, z);
                const auto p = cube_point(d);
                if (d == glm::dvec3(0)) {
                    EXPECT_FALSE(p);
                    continue;
                }
                ASSERT_TRUE(p);
                EXPECT_EQ(glm::length(cube_direction(*p) - d), 0.0) << x << y << z;
                EXPECT_NE(d[p->face / 2], 0.0);
            }
}

TEST(CubePoint, ExtremeLengthsAreFineAndNonFiniteAreNot) {
    for (double scale : {1e-44, 1e30, 3e38, 1e300}) {
        const auto p = cube_point(scale * glm::dvec3(0.2, -1, 0.4));
        ASSERT_TRUE(p) << scale;
        EXPECT_EQ(p->face, 3);
        EXPECT_NEAR(p->s, 0.6, 1e-14) << scale;
    }
    EXPECT_FALSE(cube_point({std::numeric_limits<double>::quiet_NaN(), 0, 1}));
    EXPECT_FALSE(cube_point({0, std::numeric_limits<double>::infinity(), 1}));
}

TEST(SampleCube, AtATexelsCentreIsThatTexel) {
    const Painted painted(8);
    for (int face = 0; face < 6; ++face)
        for (int row = 0; row < 8; ++row)
            for (int column = 0; column < 8; ++column) {
                const glm::dvec3 d = cube_direction({face, (column + 0.5) / 8, (row + 0.5) / 8});
                const glm::dvec3 texel = painted.faces[static_cast<std::size_t>(face)].at(column, row);
                for (Edges edges : {Edges::clamped, Edges::seamless})
                    EXPECT_LT(glm::length(sample_cube(painted.faces, d, edges) - texel), 1e-13);
            }
}

TEST(SampleCube, BetweenTwoTexelsIsTheirMean) {
    const Painted painted(8);
    const glm::dvec3 mean = (painted.faces[4].at(2, 5) + painted.faces[4].at(3, 5)) / 2.0;
    EXPECT_LT(glm::length(sample_cube(painted.faces, cube_direction({4, 3.0 / 8, 5.5 / 8})) - mean), 1e-13);
}

// Both faces of an edge must say the same on it; without the neighbour's texels they differ.
TEST(SampleCube, SeamlessIsContinuousAcrossEdgesAndCorners) {
    const Painted painted(8);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> along(-1, 1);
    double worst_seamless = 0, worst_clamped = 0;
    for (int i = 0; i < 2000; ++i) {
        glm::dvec3 d(along(random), i % 2 ? 1 : -1, i % 4 < 2 ? 1 : -1);
        if (i % 3 == 1) d = {d.y, d.z, d.x};
        if (i % 3 == 2) d = {d.z, d.x, d.y};
        glm::dvec3 a = d, b = d;
        for (int k = 0; k < 3; ++k) {
            if (std::abs(d[k]) < 1) continue;
            if (a == d)
                a[k] *= 1 + 1e-9;
            else
                b[k] *= 1 + 1e-9;
        }
        const auto gap = [&](Edges edges) {
            return glm::length(sample_cube(painted.faces, a, edges) - sample_cube(painted.faces, b, edges));
        };
        worst_seamless = std::max(worst_seamless, gap(Edges::seamless));
        worst_clamped = std::max(worst_clamped, gap(Edges::clamped));
    }
    EXPECT_LT(worst_seamless, 0.02);  // at corners, where the mean of three stands in for a fourth
    EXPECT_GT(worst_clamped, 0.05);
}

TEST(SampleCube, NoDirectionIsTheMiddleOfTheFrontFace) {
    const Painted painted(8);
    EXPECT_LT(glm::length(sample_cube(painted.faces, {0, 0, 0}) - sample_cube(painted.faces, {0, 0, 1})), 1e-15);
}

TEST(Sample2d, BottomRowOfTheImageIsAtZero) {
    const std::vector<std::uint8_t> bytes = {255, 0, 0, 255, 0, 0, 0, 0, 255, 0, 0, 255};  // red above blue
    const Texels image{2, 2, 3, bytes};
    EXPECT_LT(glm::length(sample_2d(image, 0.5, 0.25) - glm::dvec3(0, 0, 1)), 1e-15);
    EXPECT_LT(glm::length(sample_2d(image, 0.5, 0.75) - glm::dvec3(1, 0, 0)), 1e-15);
    EXPECT_LT(glm::length(sample_2d(image, 0.5, 0.0, Wrap::clamp) - glm::dvec3(0, 0, 1)), 1e-15);
    EXPECT_LT(glm::length(sample_2d(image, 0.5, 0.0, Wrap::repeat) - glm::dvec3(0.5, 0, 0.5)), 1e-15);
    EXPECT_LT(glm::length(sample_2d(image, 7.5, -3.75) - sample_2d(image, 0.5, 0.25)), 1e-15);
}

// The walls' texture coordinates, from the language: QuadYZ at x>0 has s along -z, t along +y; and so on.
TEST(WallPoint, IsWhatTheQuadsSay) {
    struct Wall {
        int face;
        glm::dvec3 s, t;
    };
    const Wall walls[] = {{0, {0, 0, -1}, {0, 1, 0}}, {1, {0, 0, 1}, {0, 1, 0}}, {2, {1, 0, 0}, {0, 0, -1}},
                          {3, {1, 0, 0}, {0, 0, 1}},  {4, {1, 0, 0}, {0, 1, 0}}, {5, {-1, 0, 0}, {0, 1, 0}}};
    for (const Wall& wall : walls) {
        glm::dvec3 middle(0);
        middle[wall.face / 2] = wall.face % 2 ? -1 : 1;
        const auto p = wall_point(middle + 0.4 * wall.s - 0.6 * wall.t);
        ASSERT_TRUE(p);
        EXPECT_EQ(p->face, wall.face);
        EXPECT_NEAR(p->s, 0.7, 1e-14) << wall.face;
        EXPECT_NEAR(p->t, 0.2, 1e-14) << wall.face;
    }
}

TEST(WallPoint, ShowsTheSameTexelAsTheCubeMap) {
    const Painted painted(16);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int i = 0; i < 500; ++i) {
        const glm::dvec3 d(any(random), any(random), any(random));
        const auto p = wall_point(d);
        ASSERT_TRUE(p);
        const glm::dvec3 wall = sample_2d(painted.faces[static_cast<std::size_t>(p->face)], p->s, p->t, Wrap::clamp);
        EXPECT_LT(glm::length(wall - sample_cube(painted.faces, d, Edges::clamped)), 1e-12);
    }
}

}  // namespace
}  // namespace snell::optics
