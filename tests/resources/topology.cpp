// How many primitives indices make, by the rules of the OpenGL specification (section 10.1).
#include "src/runtime/resources/mesh.h"
#include "tests/std.h"

namespace snell::runtime {
namespace {

struct ShapeRow {
    Topology topology;
    std::uint32_t least;  // indices of the first primitive
    std::uint32_t more;   // indices of each further one
    bool triangles;
};

TEST(Topologies, CountTheirPrimitives) {
    for (const ShapeRow& row :
         {ShapeRow{Topology::lines, 2, 2, false}, ShapeRow{Topology::line_strip, 2, 1, false},
          ShapeRow{Topology::triangles, 3, 3, true}, ShapeRow{Topology::triangle_strip, 3, 1, true},
          ShapeRow{Topology::triangle_fan, 3, 1, true}, ShapeRow{Topology::lines_adjacency, 4, 4, false},
          ShapeRow{Topology::line_strip_adjacency, 4, 1, false}, ShapeRow{Topology::triangles_adjacency, 6, 6, true},
          ShapeRow{Topology::triangle_strip_adjacency, 6, 2, true}})
        for (std::uint32_t count = 0, made = 0; count < 20; ++count) {
            if (count >= row.least && (count - row.least) % row.more == 0) ++made;
            EXPECT_EQ(triangle_count(row.topology, count), row.triangles ? made : 0) << count;
            EXPECT_EQ(line_count(row.topology, count), row.triangles ? 0 : made) << count;
        }
    for (const std::uint32_t count : {0U, 1U}) EXPECT_EQ(line_count(Topology::line_loop, count), 0U);
    EXPECT_EQ(line_count(Topology::line_loop, 2), 2U);
    EXPECT_EQ(line_count(Topology::line_loop, 7), 7U);
    for (const Topology none : {Topology::points, Topology::patches}) {
        EXPECT_EQ(triangle_count(none, 6), 0U);
        EXPECT_EQ(line_count(none, 6), 0U);
    }
}

}  // namespace
}  // namespace snell::runtime
