// Neighbours of triangles. Internal to content/.
#pragma once

#include <span>

#include "src/content/weld.h"

namespace snell::content {

// The indices of GL_TRIANGLES_ADJACENCY (v0 n01 v1 n12 v2 n20) for those of GL_TRIANGLES; n01 is the far
// corner of the triangle across the edge v0 v1. Vertices at the same place are one, whatever their normals and
// texture coordinates.
//   Across a border there is nothing: the triangle's own far corner stands there, as if it were folded back.
//   Where an edge belongs to several triangles they pair up in order, the k-th that runs along it one way
//   with the k-th that runs the other way; one that is left over takes the first of the other way, or, if all
//   run the same way, the next one.
std::vector<std::uint32_t> with_adjacency(std::span<const std::uint32_t> triangles, const Weld& weld,
                                          std::size_t* border_edges = nullptr, std::size_t* crowded_edges = nullptr);

}  // namespace snell::content
