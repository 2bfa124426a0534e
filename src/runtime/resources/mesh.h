// Meshes on the GPU.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "src/content/mesh/mesh.h"
#include "src/content/mesh/tree.h"
#include "src/gl/handle.h"
#include "src/gl/texture.h"

namespace snell::runtime {

struct StageMesh;

struct GpuMesh {
    gl::VertexArray array;
    gl::Buffer vertices, indices;
    Topology topology = Topology::triangles;
    int patch_vertices = 3;
    std::uint32_t count = 0;  // of indices
    GLenum index_type = GL_UNSIGNED_INT;
    std::vector<content::MeshPart> parts;
    bool has_color = false;
    bool has_w = false;  // some w is not 1
    content::Float3 min{}, max{};
    bool bounded = true;  // no position is outside of these: none is infinite or not a number
    std::size_t bytes = 0;
    double load_ms = 0;
    std::shared_ptr<StageMesh> stages;  // null until a program reads it
};

GpuMesh upload(const content::Mesh& mesh);
// Draws `count` of its indices from `first` on.
void draw_elements(GLenum mode, const GpuMesh& mesh, std::uint32_t first, std::uint32_t count);

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

// Meshes as rays in shaders meet them (shaders/snell/mesh.glsl): built and uploaded where a drawn program reads them.

enum class TreePart { nodes, triangles, normals };  // as glsl::mesh_samplers
inline constexpr std::size_t tree_parts = 3;

// Which part the sampler of this name and type reads; none: it is the scene's own.
std::optional<TreePart> tree_part(std::string_view sampler, std::string_view type);

// By TreePart; empty handles where no program has read the part yet.
struct GpuTree {
    std::array<gl::Texture, tree_parts> parts;
    bool built = false;
    std::size_t bytes = 0;
    double load_ms = 0;
    bool at_fault = false;  // something was said of it, and is to be said again
};

}  // namespace snell::runtime
