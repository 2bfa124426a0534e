// Meshes as rays in shaders meet them (shaders/snell/mesh.glsl): built and uploaded where a drawn program reads them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "src/content/mesh/tree.h"
#include "src/gl/texture.h"

namespace snell::runtime {

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
