// Meshes on the GPU.
#pragma once

#include <cstdint>
#include <vector>

#include "src/content/mesh/mesh.h"
#include "src/gl/handle.h"

namespace snell::runtime {

struct GpuMesh {
    gl::VertexArray array;
    gl::Buffer vertices, indices;
    Topology topology = Topology::triangles;
    int patch_vertices = 3;
    std::uint32_t count = 0;
    std::vector<content::MeshPart> parts;
    bool has_color = false;
    bool has_w = false;  // some w is not 1
    content::Float3 min{}, max{};
    bool bounded = true;  // no position is outside of these: none is infinite or not a number
    std::size_t bytes = 0;
    double load_ms = 0;
};

GpuMesh upload(const content::Mesh& mesh);

struct TopologyFacts {
    GLenum mode;   // of the draw
    GLenum input;  // what a geometry shader gets
    // `least` indices make the first primitive; of `count` indices all but `shared` make one each `step`.
    std::uint32_t least = 1, shared = 0, step = 1;

    std::uint64_t primitives(std::uint32_t count) const;
};
const TopologyFacts& facts_of(Topology topology);
// How many triangles `count` indices make; 0 for points and lines.
std::uint64_t triangle_count(Topology topology, std::uint32_t count);
std::uint64_t line_count(Topology topology, std::uint32_t count);

}  // namespace snell::runtime
