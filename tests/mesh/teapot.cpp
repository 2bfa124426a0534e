// The teapot, the soccer ball, and everything's wires.
#include "src/content/mesh/surface.h"
#include "tests/mesh/check.h"

namespace snell::content {
namespace {

using namespace check;
constexpr std::size_t side = 17, patch_size = side * side;  // vertices along and in a patch

std::uint32_t patch_of_triangle(const Mesh& m, std::size_t first) {
    return m.indices[first] / static_cast<std::uint32_t>(patch_size);
}

TEST(Teapot, HasThirtyTwoPatchesEachWithStFrom0To1) {
    const Mesh m = made(Teapot{});
    ASSERT_EQ(m.positions.size(), 32 * patch_size);
    for (std::size_t patch = 0; patch < 32; ++patch)
        for (std::size_t j = 0; j < side; ++j)
            for (std::size_t i = 0; i < side; ++i) {
                const Float3& st = m.texcoords[patch * patch_size + j * side + i];
                EXPECT_NEAR(st[0], static_cast<double>(i) / 16, 1e-7);
                EXPECT_NEAR(st[1], static_cast<double>(j) / 16, 1e-7);
            }
}

// glutSolidTeapot(1): the bottom at -.75, the knob's top at .825, the body's greatest radius near 1, the
// spout out to x = 1.7 and the handle to -1.5.
TEST(Teapot, HasGlutsSizeAndPlace) {
    const Mesh m = made(Teapot{});
    EXPECT_EQ(m.min[1], -.75f);
    EXPECT_EQ(m.max[1], .825f);
    EXPECT_NEAR(m.max[0], 1.717, .005);
    EXPECT_NEAR(m.min[0], -1.5, .005);
    EXPECT_NEAR(m.max[2], 1, .01);
    EXPECT_EQ(m.min[2], -m.max[2]);
}

TEST(Teapot, NormalsFaceAsTheTrianglesAndOutward) {
    const Mesh m = made(Teapot{});
    expect_sound(m, 0);
    // Body, lid and bottom: away from the axis' point at the height of the body's middle.
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const std::uint32_t patch = patch_of_triangle(m, i);
        const D3 c = corner(m, i), n = area_vector(m, i);
        const bool body = patch >= 4 && patch < 12, lid = patch >= 16 && patch < 20, bottom = patch >= 20 && patch < 24;
        const double outward = body ? n[0] * c[0] + n[2] * c[2] : lid ? n[1] : bottom ? -n[1] : 1;
        EXPECT_GT(outward, 0) << patch;
    }
    // Handle and spout: out of the tube, of which each ring of s is a cross-section. The spout's lip turns inward
    // halfway along its second pair of patches.
    for (std::size_t patch = 24; patch < 32; patch += 2)
        for (std::size_t j = 0; j < (patch == 30 ? side / 2 : side); ++j) {
            D3 centre{0, 0, 0};
            for (const std::size_t half : {patch, patch + 1})
                for (std::size_t i = 0; i < side; ++i)
                    for (std::size_t k = 0; k < 3; ++k)
                        centre[k] += m.positions[half * patch_size + j * side + i][k] / (2. * side);
            for (const std::size_t half : {patch, patch + 1})
                for (std::size_t i = 0; i < side; ++i) {
                    const std::size_t v = half * patch_size + j * side + i;
                    EXPECT_GT(dot(minus(wide(m.positions[v]), centre), wide(m.normals[v])), -.02) << patch << ' ' << j;
                }
        }
}

// Volume below the surface of body, bottom, rim and lid, by Pappus: 2 pi times the integral of r^2 / 2 dy
// along the same Bezier profiles. The body's own .56 quarter circles are within half a percent of circles.
TEST(Teapot, BodyHasTheVolumeOfItsProfile) {
    const Mesh m = made(Teapot{});
    const auto profile = [](std::array<double, 8> p) {
        double sum = 0;
        for (int i = 0; i < 1000; ++i) {
            const double t = (i + .5) / 1000, u = 1 - t;
            const double r = u * u * u * p[0] + 3 * u * u * t * p[2] + 3 * u * t * t * p[4] + t * t * t * p[6];
            const double dz = 3 * (u * u * (p[3] - p[1]) + 2 * u * t * (p[5] - p[3]) + t * t * (p[7] - p[5]));
            sum += pi * r * r * dz / 1000;
        }
        return std::abs(sum) / 8;  // GLUT's teapot is Newell's at half size
    };
    const double expected =
        profile({1.5, 2.4, 1.75, 1.875, 2, 1.35, 2, .9}) + profile({2, .9, 2, .45, 1.5, .225, 1.5, .15});
    // The body's two bands, closed by flat discs seen from the origin of the volume formula.
    double bands = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        if (const auto patch = patch_of_triangle(m, i); patch >= 4 && patch < 12)
            bands += dot(corner(m, i), area_vector(m, i)) / 3;
    const double top = .5 * (2.4 - 1.5), low = .5 * (.15 - 1.5), disc = pi * .75 * .75;
    EXPECT_NEAR(bands + disc * top / 3 - disc * low / 3, expected, .01 * expected);
}

TEST(Teapot, LidTipAndBaseHaveTheLimitOfTheNormals) {
    const Mesh m = made(Teapot{});
    const Float3 tip{0, .825f, 0}, base{0, -.75f, 0};
    int tips = 0, bases = 0;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        tips += m.positions[i] == tip && m.normals[i] == Float3{0, 1, 0};
        bases += m.positions[i] == base && m.normals[i] == Float3{0, -1, 0};
    }
    EXPECT_EQ(tips, 4 * 17);
    EXPECT_EQ(bases, 4 * 17);
}

// The cross product of the derivatives vanishes at the tip; its direction must not.
TEST(Teapot, NormalsAreContinuousThroughTipAndBase) {
    for (int patch = 0; patch < teapot_patches; ++patch) {
        if (patch < 12 || (patch >= 16 && patch < 20) || patch >= 24) continue;
        const D3 axis{0, patch < 16 ? 1. : -1., 0};
        for (int i = 0; i <= 64; ++i)
            for (const double t : {0., 1e-300, 1e-16, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 5e-3}) {
                const D3 n = teapot_point(patch, i / 64., t).normal;
                EXPECT_LT(std::atan2(length(cross(n, axis)), dot(n, axis)) * 180 / pi, 1) << patch << ' ' << t;
            }
    }
}

TEST(Teapot, NormalsArePerpendicularToTheSurface) {
    constexpr double h = 1e-5;
    for (int patch = 0; patch < teapot_patches; ++patch)
        for (double s = .05; s < 1; s += .1)
            for (double t = .05; t < 1; t += .1) {
                const D3 n = teapot_point(patch, s, t).normal;
                const D3 along_s =
                    minus(teapot_point(patch, s + h, t).position, teapot_point(patch, s - h, t).position);
                const D3 along_t =
                    minus(teapot_point(patch, s, t + h).position, teapot_point(patch, s, t - h).position);
                EXPECT_NEAR(dot(n, along_s) / length(n) / length(along_s), 0, 1e-6);
                EXPECT_NEAR(dot(n, along_t) / length(n) / length(along_t), 0, 1e-6);
            }
}

TEST(Teapot, PatchesJoinBitForBit) {
    const Mesh m = made(Teapot{});
    const std::vector<int> place = places(m);
    std::map<std::pair<int, int>, int> halves;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++halves[{place[m.indices[i + k]], place[m.indices[i + (k + 1) % 3]]}];
    std::size_t borders = 0;
    for (const auto& [edge, count] : halves) {
        EXPECT_EQ(count, 1);
        borders += !halves.contains({edge.second, edge.first});
    }
    // Open by design: the rim's inside, the lid's edge (4 patches each), both ends of spout and handle.
    EXPECT_EQ(borders, 16u * (4 + 4 + 2 * 2 + 2 * 2));
}

TEST(Soccerball, HasTwelvePentagonsThenTwentyHexagons) {
    const Mesh m = made(Soccerball{2});
    expect_sound(m);
    expect_closed(m);
    EXPECT_NEAR(volume(m) / (32 * pi / 3), 1, .01);
    ASSERT_EQ(m.parts.size(), 32u);
    std::uint32_t next = 0;
    for (std::size_t i = 0; i < 32; ++i) {
        EXPECT_EQ(m.parts[i].face_index, static_cast<int>(i));
        EXPECT_EQ(m.parts[i].first, next);
        next += m.parts[i].count;
        EXPECT_EQ(m.parts[i].count % (i < 12 ? 5u : 6u), 0u);
        EXPECT_EQ(m.parts[i].count / (i < 12 ? 5 : 6), m.parts[0].count / 5);
    }
    EXPECT_EQ(next, m.indices.size());
}

// The solid angle of a face of the truncated icosahedron, projected from the centre, by the spherical excess
// of its corner angles. For the pentagon the corner angle follows from five equal spherical triangles.
TEST(Soccerball, FacesHaveTheAreasOfATruncatedIcosahedron) {
    const Mesh m = made(Soccerball{1});
    const auto part_area = [&](const MeshPart& part) {
        double sum = 0;
        for (std::size_t i = part.first; i < part.first + part.count; i += 3) sum += length(area_vector(m, i));
        return sum;
    };
    const double circumradius = std::sqrt(58 + 18 * std::sqrt(5.)) / 4;  // for edge 1
    const double edge = 2 * std::asin(.5 / circumradius);                // its angle at the centre
    const auto regular_area = [&](double n) {                            // on the unit sphere
        const double corner_angle = 2 * std::asin(std::cos(pi / n) / std::cos(edge / 2));
        return n * corner_angle - (n - 2) * pi;
    };
    for (std::size_t i = 0; i < 32; ++i) EXPECT_NEAR(part_area(m.parts[i]) / regular_area(i < 12 ? 5 : 6), 1, .01) << i;
}

TEST(Soccerball, StSpansTheFaceAndPIsItsRadius) {
    const Mesh m = made(Soccerball{1});
    for (const MeshPart& part : m.parts) {
        float low_s = 1, high_s = 0, low_t = 1, high_t = 0, low_p = 1, high_p = 0;
        for (std::size_t i = part.first; i < part.first + part.count; ++i) {
            const auto [s, t, p] = m.texcoords[m.indices[i]];
            low_s = std::min(low_s, s), high_s = std::max(high_s, s);
            low_t = std::min(low_t, t), high_t = std::max(high_t, t);
            low_p = std::min(low_p, p), high_p = std::max(high_p, p);
            // p is the radius up to the polygon's shape: 1 at corners is 1 from the middle, at edges less.
            const double radius = 2 * std::hypot(s - .5, t - .5);
            EXPECT_LE(radius, p + 1e-6);
            EXPECT_GE(radius, p * std::cos(pi / 5) - 1e-6);
        }
        EXPECT_EQ(low_p, 0);
        EXPECT_EQ(high_p, 1);
        EXPECT_LT(low_s, .1);
        EXPECT_EQ(high_s, 1);
        EXPECT_LT(low_t, .1);
        EXPECT_GT(high_t, .9);
        EXPECT_GE(std::min(low_s, low_t), 0);
    }
}

TEST(Soccerball, SeamsArePAtOneAndOnTheSphere) {
    const Mesh m = made(Soccerball{3});
    const std::vector<int> place = places(m);
    std::map<int, std::vector<float>> ps;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        EXPECT_NEAR(length(wide(m.positions[i])), 3, 1e-5);
        EXPECT_NEAR(dot(wide(m.positions[i]), wide(m.normals[i])), 3, 1e-5);
        ps[place[i]].push_back(m.texcoords[i][2]);
    }
    for (const auto& [at, values] : ps)  // shared by faces exactly where p is 1
        for (const float p : values) EXPECT_EQ(values.size() > 1, p == 1);
}

TEST(Soccerball, TangentIsTheDirectionOfGrowingS) {
    const Mesh m = made(Soccerball{1});
    ASSERT_EQ(m.tangents.size(), m.positions.size());
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        EXPECT_NEAR(length(wide(m.tangents[i])), 1, 1e-6);
        EXPECT_NEAR(dot(wide(m.tangents[i]), wide(m.normals[i])), 0, 1e-6);
    }
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = m.indices[i + k], b = m.indices[i + (k + 1) % 3];
            const double ds = m.texcoords[b][0] - m.texcoords[a][0], dt = m.texcoords[b][1] - m.texcoords[a][1];
            if (ds <= 2 * std::abs(dt)) continue;
            EXPECT_GT(dot(minus(wide(m.positions[b]), wide(m.positions[a])), wide(m.tangents[a])), 0);
        }
}

// ---- wires -------------------------------------------------------------------------------------------

TEST(Wires, HaveEachEdgeOnce) {
    const std::vector<std::pair<Shape, std::size_t>> solids{
        {Sphere{1, 12, 6}, 12 * 6 + 12 * 5},          // meridians and parallels
        {Torus{1, .5, 8, 10}, 2 * 8 * 10},            //
        {Cone{1, 1, 9, 2}, 9 * 2 + 9 * 2 + 9},        // rings, sides, spokes of the cap
        {Cylinder{1, 1, 9, 2}, 9 * 3 + 9 * 2 + 18},   //
        {Box{}, 12},                                  //
        {Quad{Plane::xz, 0, 1, 3, 2}, 3 * 3 + 4 * 2}  //
    };
    for (const auto& [shape, edges] : solids) {
        const Mesh m = made(shape, true);
        EXPECT_EQ(m.topology, Topology::lines);
        EXPECT_TRUE(m.parts.empty());
        expect_sound(m);
        const auto lines = lines_by_place(m);
        EXPECT_EQ(lines.size(), edges) << shape.index();
        for (const auto& [edge, count] : lines) {
            EXPECT_EQ(count, 1);
            EXPECT_NE(edge.first, edge.second);
        }
    }
}

TEST(Wires, AreEdgesOfTheSolid) {
    for (const Shape& shape : {Shape{Sphere{}}, Shape{Torus{}}, Shape{Soccerball{}}, Shape{Xarrow{10}}}) {
        const Mesh solid = made(shape), wire = made(shape, true);
        std::map<std::pair<Float3, Float3>, int> edges;
        for (std::size_t i = 0; i < solid.indices.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                ++edges[{solid.positions[solid.indices[i + k]], solid.positions[solid.indices[i + (k + 1) % 3]]}];
        for (std::size_t i = 0; i < wire.indices.size(); i += 2)
            ASSERT_TRUE(edges.contains({wire.positions[wire.indices[i]], wire.positions[wire.indices[i + 1]]}))
                << shape.index();
    }
}

TEST(Wires, OfTheTeapotHaveGlutsTenStepsAPatch) {
    const Mesh m = made(Teapot{}, true);
    EXPECT_EQ(m.topology, Topology::lines);
    EXPECT_EQ(m.positions.size(), 32u * 121);
    for (const auto& [edge, count] : lines_by_place(m)) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace snell::content
