// ObjAdj, ObjPatch and WireObj.
#include "src/content/mesh/mesh.h"
#include "tests/mesh/obj_check.h"

namespace snell::content {
namespace {

using namespace check;

// For every triangle and edge of a closed mesh, the neighbour is the far corner of the one other triangle
// that has the edge, found here by looking through all of them.
TEST(ObjAdjacency, HoldsItsDefinitionOnAClosedMesh) {
    const Mesh m = clean(as_obj(made(Torus{1, .5, 8, 9}), true), ObjAs::adjacency);
    EXPECT_EQ(m.topology, Topology::triangles_adjacency);
    ASSERT_EQ(m.indices.size(), 6u * 2 * 8 * 9);
    const std::vector<int> place = places(m);
    for (std::size_t i = 0; i < m.indices.size(); i += 6)
        for (std::size_t k = 0; k < 6; k += 2) {
            const int from = place[m.indices[i + k]], to = place[m.indices[i + (k + 2) % 6]];
            const int neighbour = place[m.indices[i + k + 1]];
            int found = 0;
            for (std::size_t j = 0; j < m.indices.size(); j += 6)
                for (std::size_t h = 0; h < 6; h += 2) {
                    if (place[m.indices[j + h]] != to || place[m.indices[j + (h + 2) % 6]] != from) continue;
                    ++found;
                    EXPECT_EQ(place[m.indices[j + (h + 4) % 6]], neighbour);
                }
            EXPECT_EQ(found, 1);
        }
}

TEST(ObjAdjacency, KeepsTheTriangles) {
    const Mesh plain = clean(cube), m = clean(cube, ObjAs::adjacency);
    ASSERT_EQ(m.indices.size(), 2 * plain.indices.size());
    for (std::size_t i = 0; i < plain.indices.size(); ++i) EXPECT_EQ(m.indices[2 * i], plain.indices[i]);
}

TEST(ObjAdjacency, FoldsBordersBack) {
    const Mesh m = clean(square + "f 1 2 3\n", ObjAs::adjacency);
    EXPECT_EQ(m.indices, (std::vector<std::uint32_t>{0, 2, 1, 0, 2, 1}));
}

TEST(ObjAdjacency, CrowdedEdgesPairUpInOrder) {
    // Four triangles on the edge 1 2: two each way. Far corners 3, 4 along it, 5, 6 against it.
    const std::string fins = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 0 0 -1\n";
    const MeshResult r = parse(fins + "f 1 2 3\nf 1 2 4\nf 2 1 5\nf 2 1 6\n", ObjAs::adjacency);
    EXPECT_TRUE(has_issue(r, "obj-not-manifold"));
    const auto across = [&](std::size_t triangle) { return r.mesh.positions[r.mesh.indices[6 * triangle + 1]]; };
    EXPECT_EQ(across(0), (Float3{0, -1, 0}));
    EXPECT_EQ(across(1), (Float3{0, 0, -1}));
    EXPECT_EQ(across(2), (Float3{0, 1, 0}));
    EXPECT_EQ(across(3), (Float3{0, 0, 1}));
    // Three: the one left over takes the first of the other way.
    const MeshResult three = parse(fins + "f 1 2 3\nf 1 2 4\nf 2 1 5\n", ObjAs::adjacency);
    EXPECT_EQ(three.mesh.positions[three.mesh.indices[7]], (Float3{0, -1, 0}));
    // Two that run the same way are each other's neighbours.
    const MeshResult same = parse(fins + "f 1 2 3\nf 1 2 4\n", ObjAs::adjacency);
    EXPECT_TRUE(has_issue(same, "obj-not-manifold"));
    EXPECT_EQ(same.mesh.positions[same.mesh.indices[1]], (Float3{0, 0, 1}));
    EXPECT_EQ(same.mesh.positions[same.mesh.indices[7]], (Float3{0, 1, 0}));
}

TEST(ObjPatch, GivesPatchesOfThree) {
    const Mesh m = clean(cube, ObjAs::patches);
    EXPECT_EQ(m.topology, Topology::patches);
    EXPECT_EQ(m.patch_vertices, 3);
    EXPECT_EQ(m.indices, clean(cube).indices);
}

TEST(WireObj, HasThePolygonsEdgesOnce) {
    const Mesh m = clean(cube, ObjAs::triangles, true);
    EXPECT_EQ(m.topology, Topology::lines);
    EXPECT_EQ(lines_by_place(m).size(), 12u);  // no diagonals
    EXPECT_EQ(m.indices.size(), 24u);
}

TEST(WireObj, DrawsLineElements) {
    const Mesh m = clean(square + "vt .5 .5\nl 1 2 3\nl -1/1 1/1\nl 1 2 # again\n", ObjAs::triangles, true);
    EXPECT_EQ(m.indices.size(), 6u);
    EXPECT_TRUE(has_issue(parse(square + "l 1 9 2\nf 1 2 3\n", ObjAs::triangles, true), "obj-index-out-of-range"));
}

// Many, so that no two of different hashes meet by chance.
TEST(Weld, ZeroIsOnePlaceWhateverItsSign) {
    std::vector<Float3> positions;
    for (int i = 0; i < 32; ++i)
        for (const float zero : {0.f, -0.f}) positions.push_back({zero, static_cast<float>(i), zero});
    const Weld found = weld(positions);
    EXPECT_EQ(found.places, 32u);
    for (std::size_t i = 0; i < positions.size(); ++i) EXPECT_EQ(found.place[i], i / 2);
}

}  // namespace
}  // namespace snell::content
