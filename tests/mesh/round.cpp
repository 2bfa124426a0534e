// Spheres, tori, cones, cylinders, discs and arrows.
#include "tests/mesh/check.h"

namespace snell::content {
namespace {

using namespace check;

// Volumes and areas of a polygonal approximation with n around fall short by about (2 pi / n)^2 / 6.
constexpr double tessellation = .01;

struct Solid {
    std::string name;
    Shape shape;
    double volume, area;
};

class ClosedSolid : public testing::TestWithParam<Solid> {};

TEST_P(ClosedSolid, IsClosedOutwardAndOfTheRightSize) {
    const Mesh m = made(GetParam().shape);
    expect_sound(m);
    expect_closed(m);
    EXPECT_NEAR(volume(m) / GetParam().volume, 1, tessellation);
    EXPECT_NEAR(area(m) / GetParam().area, 1, tessellation);
    for (const Float3& t : m.texcoords) {
        EXPECT_GE(*std::min_element(t.begin(), t.end()), 0);
        EXPECT_LE(*std::max_element(t.begin(), t.end()), 1);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, ClosedSolid,
                         testing::Values(Solid{"Sphere", Sphere{}, 4 * pi / 3, 4 * pi},
                                         Solid{"SphereOdd", Sphere{2, 61, 37}, 32 * pi / 3, 16 * pi},
                                         Solid{"Torus", Torus{1, .5, 60, 60}, 2 * pi* pi * .25, 4 * pi* pi * .5},
                                         Solid{"TorusThin", Torus{3, .25, 41, 43}, 2 * pi* pi * 3 * .0625,
                                               4 * pi* pi * .75},
                                         Solid{"Cone", Cone{1, 2, 60, 3}, 2 * pi / 3, pi*(1 + std::sqrt(5.))},
                                         Solid{"ConeHanging", Cone{1, -2, 60, 3}, 2 * pi / 3, pi*(1 + std::sqrt(5.))},
                                         Solid{"Cylinder", Cylinder{.5, 3, 60, 7}, .75 * pi, .5 * pi + 3 * pi},
                                         Solid{"CylinderHanging", Cylinder{.5, -3, 60, 1}, .75 * pi, .5 * pi + 3 * pi},
                                         Solid{"Box", Box{1, 2, 3}, 6, 22}, Solid{"BoxCube", Box{}, 8, 24}),
                         [](const auto& solid) { return solid.param.name; });

// The parametrisation of glman's own pictures.
TEST(Sphere, FollowsItsFormula) {
    const Mesh m = made(Sphere{1.5, 24, 12});
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        const double lng = -pi + 2 * pi * m.texcoords[i][0], lat = -pi / 2 + pi * m.texcoords[i][1];
        const D3 n{std::cos(lng) * std::cos(lat), std::sin(lat), -std::sin(lng) * std::cos(lat)};
        for (std::size_t k = 0; k < 3; ++k) {
            EXPECT_NEAR(m.positions[i][k], 1.5 * n[k], 1e-6);
            EXPECT_NEAR(m.normals[i][k], n[k], 1e-6);
        }
    }
}

TEST(Sphere, TangentPointsNorth) {
    const Mesh m = made(Sphere{2, 30, 15});
    ASSERT_EQ(m.tangents.size(), m.positions.size());
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        const D3 t = wide(m.tangents[i]), n = wide(m.normals[i]);
        EXPECT_NEAR(length(t), 1, 1e-6);
        EXPECT_NEAR(dot(t, n), 0, 1e-6);
        const double cos_lat = std::hypot(n[0], n[2]);
        EXPECT_NEAR(t[1], cos_lat, 1e-6);  // north is up except at the poles
        if (cos_lat > 1e-6) {              // and has no part along the parallel
            EXPECT_NEAR(t[0] * -n[2] + t[2] * n[0], 0, 1e-6);
            continue;
        }
        // At a pole the limit along the vertex's own meridian: inward there from the south, on from the north.
        const double lng = -pi + 2 * pi * m.texcoords[i][0], away = n[1] > 0 ? -1 : 1;
        EXPECT_NEAR(t[0], away * std::cos(lng), 1e-6);
        EXPECT_NEAR(t[2], away * -std::sin(lng), 1e-6);
    }
}

TEST(Sphere, PolesAreExactAndSpendNoDegenerateTriangles) {
    const Mesh m = made(Sphere{1, 60, 60});
    EXPECT_EQ(m.indices.size() / 3, 2u * 60 * 59);
    int poles = 0;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        if (m.texcoords[i][1] != 0 && m.texcoords[i][1] != 1) continue;
        const float side = m.texcoords[i][1] == 0 ? -1.f : 1.f;
        EXPECT_EQ(m.positions[i], (Float3{0, side, 0}));
        EXPECT_EQ(m.normals[i], (Float3{0, side, 0}));
        ++poles;
    }
    EXPECT_EQ(poles, 2 * 61);
}

TEST(Sphere, IsDrawnFromTheSouthPoleUp) {
    const Mesh m = made(Sphere{});
    double last = -2;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const double lowest = std::min({corner(m, i)[1], corner(m, i + 1)[1], corner(m, i + 2)[1]});
        EXPECT_GE(lowest, last - 1e-7);
        last = lowest;
    }
}

TEST(Seams, AreEqualBitForBit) {
    for (const int slices : {3, 7, 60, 61, 997}) {
        const Mesh m = made(Sphere{1, slices, 5});
        const auto row = static_cast<std::size_t>(slices) + 1;
        for (std::size_t j = 0; j <= 5; ++j) {
            EXPECT_EQ(m.positions[j * row], m.positions[j * row + row - 1]);
            EXPECT_EQ(m.normals[j * row], m.normals[j * row + row - 1]);
        }
        expect_closed(m);
        expect_closed(made(Torus{1, .3, slices, std::min(slices, 61)}));
    }
}

TEST(Torus, LiesInXZAboutY) {
    const Mesh m = made(Torus{2, .5, 20, 40});
    EXPECT_FLOAT_EQ(m.max[0], 2.5f);
    EXPECT_FLOAT_EQ(m.max[1], .5f);
    EXPECT_FLOAT_EQ(m.max[2], 2.5f);
    for (const Float3& p : m.positions) EXPECT_NEAR(std::hypot(std::hypot(p[0], p[2]) - 2, p[1]), .5, 1e-6);
}

TEST(Torus, TakesTheRadiiInEitherOrder) {
    const MeshResult swapped = make_shape(Torus{.2, 1}, false);
    EXPECT_TRUE(swapped.issues.empty());
    EXPECT_EQ(swapped.mesh.positions, made(Torus{1, .2}).positions);
}

TEST(Torus, WithoutHoleIsDefinedAndReported) {
    const MeshResult r = make_shape(Torus{1, 1, 20, 40}, false);
    EXPECT_TRUE(has_issue(r, "torus-without-hole"));
    expect_sound(r.mesh);
}

TEST(Cone, StandsOnTheGroundWithTAlongTheAxis) {
    const Mesh m = made(Cone{2, 3, 16, 4});
    EXPECT_EQ(m.min, (Float3{-2, 0, -2}));
    EXPECT_EQ(m.max, (Float3{2, 3, 2}));
    for (std::size_t i = 0; i < m.positions.size(); ++i) EXPECT_NEAR(m.texcoords[i][1], m.positions[i][1] / 3, 1e-6);
}

TEST(Cone, SideNormalsArePerpendicularToTheSideUpToTheApex) {
    const Mesh m = made(Cone{1, 2, 16, 4});
    const double up = 1 / std::sqrt(5.);  // of (height, radius) = (2, 1)
    int sides = 0;
    for (const Float3& n : m.normals) {
        if (n == Float3{0, -1, 0}) continue;
        EXPECT_NEAR(n[1], up, 1e-6);
        ++sides;
    }
    EXPECT_EQ(sides, 17 * 5);
}

TEST(Cylinder, StandsOnTheGround) {
    const Mesh m = made(Cylinder{.5, 3});
    EXPECT_EQ(m.min, (Float3{-.5f, 0, -.5f}));
    EXPECT_EQ(m.max, (Float3{.5f, 3, .5f}));
    const Mesh hanging = made(Cylinder{.5, -3});
    EXPECT_EQ(hanging.min[1], -3);
    EXPECT_EQ(hanging.max[1], 0);
}

TEST(Disk, IsADiscFacingZ) {
    const Mesh m = made(Disk{.25, 2, 60, 3});
    expect_sound(m);
    EXPECT_NEAR(area(m) / (4 * pi), 1, .01);
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        EXPECT_EQ(m.positions[i][2], .25f);
        EXPECT_EQ(m.normals[i], (Float3{0, 0, 1}));
        EXPECT_NEAR(m.texcoords[i][0], .5 + m.positions[i][0] / 4, 1e-6);
        EXPECT_NEAR(m.texcoords[i][1], .5 + m.positions[i][1] / 4, 1e-6);
    }
}

TEST(Xarrow, RunsAlongXFrom0To1InSlices) {
    const Mesh m = made(Xarrow{100});
    expect_sound(m, -1e-6);
    expect_closed(m);
    EXPECT_GT(volume(m), 0);
    EXPECT_EQ(m.min[0], 0);
    EXPECT_EQ(m.max[0], 1);
    EXPECT_EQ(-m.min[1], m.max[1]);
    std::vector<float> xs;
    for (const Float3& p : m.positions) xs.push_back(p[0]);
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
    EXPECT_EQ(xs.size(), 101u);
}

TEST(Counts, BelowTheLeastAreMendedAndReported) {
    for (const int n : {-5, 0, 1, 2}) {
        const MeshResult r = make_shape(Sphere{1, n, 60}, false);
        EXPECT_TRUE(has_issue(r, "too-few-slices"));
        expect_closed(r.mesh);
        EXPECT_GT(volume(r.mesh), 0);
        EXPECT_TRUE(has_issue(make_shape(Torus{1, .5, n, 40}, false), "too-few-sides"));
        EXPECT_TRUE(has_issue(make_shape(Torus{1, .5, 20, n}, false), "too-few-rings"));
        EXPECT_TRUE(has_issue(make_shape(Cone{1, 1, n, 1}, false), "too-few-slices"));
        EXPECT_TRUE(has_issue(make_shape(Cylinder{1, 1, n, 1}, false), "too-few-slices"));
    }
    EXPECT_TRUE(has_issue(make_shape(Sphere{1, 60, 1}, false), "too-few-stacks"));
    EXPECT_TRUE(has_issue(make_shape(Cone{1, 1, 60, 0}, false), "too-few-stacks"));
}

TEST(Counts, OverTheLimitAreMendedBeforeMemoryIsTaken) {
    constexpr int huge = std::numeric_limits<int>::max();
    const MeshLimits limits{100'000, 1 << 20};
    for (const Shape& shape :
         {Shape{Sphere{1, huge, huge}}, Shape{Torus{1, .5, huge, huge}}, Shape{Cone{1, 1, huge, huge}},
          Shape{Cylinder{1, 1, huge, huge}}, Shape{Disk{0, 1, huge, huge}}, Shape{QuadBox{huge}}, Shape{Xarrow{huge}},
          Shape{Quad{Plane::xy, 0, 1, huge, huge}}, Shape{PointCloud{huge, huge, huge}}}) {
        const MeshResult r = make_shape(shape, false, limits);
        EXPECT_TRUE(has_issue(r, "too-many-vertices")) << shape.index();
        EXPECT_LE(r.mesh.positions.size(), 100'000u) << shape.index();
        EXPECT_FALSE(r.mesh.positions.empty()) << shape.index();
    }
}

TEST(Sizes, OddOnesAreDefined) {
    EXPECT_TRUE(has_issue(make_shape(Sphere{0}, false), "zero-size"));
    EXPECT_TRUE(make_shape(Sphere{0}, false).mesh.indices.empty());
    const MeshResult negative = make_shape(Sphere{-2}, false);
    EXPECT_TRUE(has_issue(negative, "negative-size"));
    EXPECT_NEAR(volume(negative.mesh), 4 * pi / 3 * 8, .4);
    EXPECT_TRUE(has_issue(make_shape(Torus{-1, -.5}, false), "negative-size"));
    EXPECT_TRUE(has_issue(make_shape(Box{1, 0, 1}, false), "zero-size"));
    EXPECT_TRUE(has_issue(make_shape(Cylinder{1, 0}, false), "zero-size"));
    EXPECT_NEAR(area(make_shape(Cylinder{1, 0}, false).mesh), 2 * pi, .02);
    for (const double bad : {std::nan(""), double{INFINITY}, 1e39, -1e300}) {
        const MeshResult r = make_shape(Sphere{bad}, false);
        EXPECT_TRUE(has_issue(r, "size-not-finite"));
        EXPECT_TRUE(r.mesh.positions.empty());
    }
    for (const double odd : {1e-30, 1e30}) {  // small and large, but sizes
        const MeshResult r = make_shape(Sphere{odd}, false);
        EXPECT_TRUE(r.issues.empty());
        EXPECT_EQ(r.mesh.max[1], static_cast<float>(odd));
        expect_closed(r.mesh);
    }
}

}  // namespace
}  // namespace snell::content
