// Neighbours of triangles, for geometry shaders. Internal to src/content.
#pragma once

#include <span>

#include "src/content/mesh/weld.h"

namespace snell::content {

// Converts indices of GL_TRIANGLES to those of GL_TRIANGLES_ADJACENCY (v0 n01 v1 n12 v2 n20), where n01 is the opposite
// corner of the triangle across the edge v0 v1. Vertices at the same place count as one, whatever their normals and
// texture coordinates. At a border there is no neighbour; the triangle's own opposite corner is used, as if it were
// folded back. If an edge belongs to several triangles, they are paired in order: the k-th that runs along the edge in
// one direction with the k-th that runs in the other. One without a partner takes the first of the other direction or,
// if all run in the same direction, the next one.
std::vector<std::uint32_t> with_adjacency(std::span<const std::uint32_t> triangles, const Weld& weld,
                                          std::size_t* border_edges = nullptr, std::size_t* crowded_edges = nullptr);

}  // namespace snell::content
