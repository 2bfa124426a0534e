// Boxes, quads, point clouds and vertex lists.
#include "tests/mesh/check.h"

namespace snell::content {
namespace {

using namespace check;

TEST(Box, HasTheLengthsOfItsSidesAndFlatFaces) {
    const Mesh m = made(Box{1, 2, 3});
    EXPECT_EQ(m.min, (Float3{-.5f, -1, -1.5f}));
    EXPECT_EQ(m.max, (Float3{.5f, 1, 1.5f}));
    expect_sound(m, .999999);
    const D3 shadows{6, 3, 2};
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(shadow(m, axis), shadows[axis], 1e-6);
}

// Seen from outside, s runs to the right and t up: their cross product is the face's normal.
TEST(Box, FacesAreReadableFromOutside) {
    const Mesh m = made(Box{});
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const auto st = [&](std::size_t k) { return m.texcoords[m.indices[i + k]]; };
        const double turn =
            (st(1)[0] - st(0)[0]) * (st(2)[1] - st(0)[1]) - (st(1)[1] - st(0)[1]) * (st(2)[0] - st(0)[0]);
        EXPECT_GT(turn, 0);
    }
}

// How s and t run on glman's walls, measured on its screen shots.
struct Wall {
    std::string name;
    Plane plane;
    double offset;
    D3 s, t;
};
class Walls : public testing::TestWithParam<Wall> {};

TEST_P(Walls, RunAsMeasured) {
    const auto& [name, plane, offset, s, t] = GetParam();
    const Mesh m = made(Quad{plane, offset, 5, 3, 4});
    expect_sound(m, .999999);
    EXPECT_NEAR(area(m), 100, 1e-4);
    EXPECT_EQ(m.positions.size(), 4u * 5);
    const std::size_t axis = plane == Plane::xy ? 2 : plane == Plane::xz ? 1 : 0;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        const D3 p = wide(m.positions[i]);
        EXPECT_EQ(m.positions[i][axis], static_cast<float>(offset));
        EXPECT_EQ(m.normals[i][axis], 1);
        EXPECT_NEAR(m.texcoords[i][0], .5 + dot(p, s) / 10, 1e-6);
        EXPECT_NEAR(m.texcoords[i][1], .5 + dot(p, t) / 10, 1e-6);
    }
}

constexpr D3 px{1, 0, 0}, nx{-1, 0, 0}, py{0, 1, 0}, pz{0, 0, 1}, nz{0, 0, -1};
INSTANTIATE_TEST_SUITE_P(Quad, Walls,
                         testing::Values(Wall{"XyBeyond", Plane::xy, 5, px, py}, Wall{"XyAt0", Plane::xy, 0, px, py},
                                         Wall{"XyBehind", Plane::xy, -5, nx, py}, Wall{"XzAbove", Plane::xz, 5, px, nz},
                                         Wall{"XzBelow", Plane::xz, -5, px, pz}, Wall{"YzRight", Plane::yz, 5, nz, py},
                                         Wall{"YzLeft", Plane::yz, -5, pz, py}),
                         [](const auto& wall) { return wall.param.name; });

// Six walls split alike meet in the same vertices.
TEST(Quads, OfARoomJoinWithoutSeams) {
    std::map<Float3, int> edge_points;
    for (const double side : {5., -5.})
        for (const Plane plane : {Plane::xy, Plane::xz, Plane::yz})
            for (const Float3& p : made(Quad{plane, side, 5, 7, 7}).positions)
                if ((std::abs(p[0]) == 5) + (std::abs(p[1]) == 5) + (std::abs(p[2]) == 5) >= 2) ++edge_points[p];
    EXPECT_EQ(edge_points.size(), 12u * 6 + 8);
    for (const auto& [p, walls] : edge_points)
        EXPECT_EQ(walls, (std::abs(p[0]) == 5) + (std::abs(p[1]) == 5) + (std::abs(p[2]) == 5));
}

TEST(Quads, OddParametersAreMended) {
    EXPECT_TRUE(has_issue(make_shape(Quad{Plane::xy, 0, 1, 0, 1}, false), "too-few-cells"));
    EXPECT_TRUE(has_issue(make_shape(Quad{Plane::xy, 0, -1, 1, 1}, false), "negative-size"));
    EXPECT_NEAR(area(make_shape(Quad{Plane::xy, 0, -1, 1, 1}, false).mesh), 4, 1e-6);
    EXPECT_TRUE(has_issue(make_shape(Quad{Plane::xy, std::nan(""), 1, 1, 1}, false), "size-not-finite"));
}

TEST(QuadBox, FillsTheCubeBackToFront) {
    const Mesh m = made(QuadBox{11});
    expect_sound(m, .999999);
    EXPECT_NEAR(area(m), 44, 1e-4);
    EXPECT_EQ(m.min, (Float3{-1, -1, -1}));
    EXPECT_EQ(m.max, (Float3{1, 1, 1}));
    double last = -2;
    for (const std::uint32_t i : m.indices) {
        EXPECT_GE(m.positions[i][2], last);
        last = m.positions[i][2];
    }
    for (std::size_t i = 0; i < m.positions.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(m.texcoords[i][k], (m.positions[i][k] + 1) / 2, 1e-6);
    EXPECT_EQ(made(QuadBox{1}).max[2], 0);
    EXPECT_TRUE(has_issue(make_shape(QuadBox{0}, false), "too-few-quads"));
}

TEST(PointCloud, IsRegularFromMinus1To1) {
    const Mesh m = made(PointCloud{3, 4, 5});
    EXPECT_EQ(m.topology, Topology::points);
    EXPECT_EQ(m.positions.size(), 60u);
    EXPECT_EQ(m.indices.size(), 60u);
    expect_sound(m);
    EXPECT_EQ(m.min, (Float3{-1, -1, -1}));
    EXPECT_EQ(m.max, (Float3{1, 1, 1}));
    EXPECT_EQ(std::set<Float3>(m.positions.begin(), m.positions.end()).size(), 60u);
    EXPECT_EQ(made(PointCloud{1, 1, 1}).positions[0], (Float3{0, 0, 0}));
}

TEST(JitterCloud, HasOnePointInEachCellAndIsAlwaysTheSame) {
    const Mesh m = made(PointCloud{6, 5, 4, true});
    EXPECT_EQ(m.positions, made(PointCloud{6, 5, 4, true}).positions);
    EXPECT_NE(m.positions, made(PointCloud{6, 5, 4}).positions);
    std::map<std::array<int, 3>, int> cells;
    for (const Float3& p : m.positions) {
        const auto cell = [&](std::size_t k, int n) { return static_cast<int>(std::floor((p[k] + 1) / 2 * n)); };
        ++cells[{cell(0, 6), cell(1, 5), cell(2, 4)}];
    }
    EXPECT_EQ(cells.size(), 120u);
    EXPECT_EQ(cells.begin()->first, (std::array{0, 0, 0}));
    EXPECT_EQ(cells.rbegin()->first, (std::array{5, 4, 3}));
}

VertexListData three_vertices(Topology topology) {
    VertexListData list;
    list.topology = topology;
    list.vertices = {{{0, 0, 0, 1}}, {{1, 0, 0, 1}}, {{0, 1, 0, 1}}};
    return list;
}

TEST(VertexList, KeepsItsTopologyAndOrder) {
    for (const Topology topology :
         {Topology::points, Topology::lines, Topology::line_strip, Topology::line_loop, Topology::triangles,
          Topology::triangle_strip, Topology::triangle_fan, Topology::lines_adjacency, Topology::line_strip_adjacency,
          Topology::triangles_adjacency, Topology::triangle_strip_adjacency, Topology::patches}) {
        VertexListData list = three_vertices(topology);
        list.patch_vertices = 16;
        const Mesh m = make_vertex_list(list).mesh;
        EXPECT_EQ(m.topology, topology);
        EXPECT_EQ(m.patch_vertices, 16);
        EXPECT_EQ(m.indices, (std::vector<std::uint32_t>{0, 1, 2}));
        EXPECT_EQ(m.positions[1], (Float3{1, 0, 0}));
        EXPECT_EQ(m.max, (Float3{1, 1, 0}));
        EXPECT_TRUE(m.w.empty());
        EXPECT_TRUE(m.colors.empty());
    }
}

TEST(VertexList, PassesOnWColorsNormalsAndTexcoords) {
    VertexListData list = three_vertices(Topology::patches);
    list.vertices[1].position[3] = .5;
    list.vertices[1].normal = {0, 3, 4};
    list.vertices[2].normal = {0, 0, 0};
    list.vertices[2].texcoord = {.1, .2, .3};
    list.vertices[2].color = {.25, .5, .75, .125};
    list.has_color = true;
    const Mesh m = make_vertex_list(list).mesh;
    EXPECT_EQ(m.w, (std::vector<float>{1, .5f, 1}));
    EXPECT_EQ(m.normals[1], (Float3{0, .6f, .8f}));
    EXPECT_EQ(m.normals[2], (Float3{0, 0, 1}));
    EXPECT_EQ(m.texcoords[2], (Float3{.1f, .2f, .3f}));
    ASSERT_EQ(m.colors.size(), 3u);
    EXPECT_EQ(m.colors[0], (Float4{1, 1, 1, 1}));
    EXPECT_EQ(m.colors[2], (Float4{.25f, .5f, .75f, .125f}));
}

TEST(VertexList, WithoutVerticesIsEmpty) {
    const MeshResult r = make_vertex_list({});
    EXPECT_TRUE(r.mesh.positions.empty());
    EXPECT_EQ(r.mesh.bytes(), 0u);
    EXPECT_EQ(r.mesh.max, (Float3{0, 0, 0}));
}

TEST(Mesh, CountsItsBytes) {
    const Mesh m = made(Sphere{1, 8, 4});
    const std::size_t vertices = 9 * 5;
    EXPECT_EQ(m.bytes(), vertices * 4 * 12 + m.indices.size() * 4);  // with tangents
}

TEST(Mesh, ShapesWithDataElsewhereAreRefused) {
    for (const Shape& shape : {Shape{ObjFile{}}, Shape{ShpFile{}}, Shape{VertexList{}}})
        EXPECT_TRUE(make_shape(shape, false).issues.at(0).error);
}

}  // namespace
}  // namespace snell::content
