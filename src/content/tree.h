// A mesh's triangles in a hierarchy of boxes, laid out as texels of RGBA32F for rays on the GPU
// (shaders/snell/mesh.glsl). No GL here.
#pragma once

#include <cstddef>
#include <vector>

#include "src/content/mesh.h"

namespace snell::content {

// Whole numbers in texels are floats, exact below this.
inline constexpr std::size_t tree_limit = std::size_t{1} << 24;
inline constexpr std::size_t tree_leaf = 4;    // triangles in a leaf, at most
inline constexpr std::size_t tree_depth = 32;  // nodes from the root to a leaf, at most: a walk's stack

struct Tree {
    // Two for each node, the root first: (low corner of the box, link) and (high corner, kind). Kind > 0: a leaf of
    // as many triangles, `link` the first of them. Else two nodes, apart along axis -kind - 1: the one lower there
    // follows at once, `link` is the other. The box of a node without triangles is inside out.
    std::vector<Float4> nodes;
    // Three for each triangle, in the order of the leaves: a corner, counter-clockwise seen from outside, and the
    // number of its vertex in the mesh.
    std::vector<Float4> triangles;

    std::size_t triangle_count() const { return triangles.size() / 3; }
    std::size_t bytes() const { return (nodes.size() + triangles.size()) * sizeof(Float4); }
};

// Of the triangles of every topology that has them, split where the surface area heuristic says (Wald 2007, by bins
// along the longest side), or at the median where else it would get too deep. Triangles that have no finite corners
// or name a vertex that is not there are left out. `too_large`: the mesh has tree_limit triangles or vertices or
// more, and the tree is that of an empty mesh.
Tree make_tree(const Mesh& mesh, bool* too_large = nullptr);

// One texel for each vertex, w 0. A mesh without normals: one texel of zeros.
std::vector<Float4> tree_normals(const Mesh& mesh);

}  // namespace snell::content
