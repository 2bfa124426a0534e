// A bounding volume hierarchy over a mesh's triangles, as RGBA32F texels that shaders trace rays through
// (shaders/snell/mesh.glsl). No GL.
#pragma once

#include <cstddef>
#include <vector>

#include "src/content/mesh/mesh.h"

namespace snell::content {

// Indices are stored as floats, which are exact below this.
inline constexpr std::size_t tree_limit = std::size_t{1} << 24;
inline constexpr std::size_t tree_leaf = 4;  // maximum number of triangles in a leaf
// Maximum number of nodes from the root to a leaf, which bounds the traversal's stack.
inline constexpr std::size_t tree_depth = 32;

struct Tree {
    // Two texels for each node, the root first: (low corner of the box, link) and (high corner, kind). If kind > 0, the
    // node is a leaf of that many triangles, and `link` is the first of them. Otherwise it has two children, separated
    // along the axis -kind - 1: the lower one is the next node, the other is `link`. A node without triangles has an
    // inverted box. The last texel is the tree's frame: its origin in the model, and its scale. All coordinates here
    // are (model - origin) * scale, so that the mesh lies around 0 with a size near 1 and float rounding is relative to
    // its size. The origin is 0 for a mesh that lies near the model's. The scale is a power of two, which rounds
    // nothing.
    std::vector<Float4> nodes;
    // Three texels for each triangle, in the order of the leaves: each has a corner (counter-clockwise seen from
    // outside) and the number of its vertex in the mesh.
    std::vector<Float4> triangles;
    bool too_large = false;  // the mesh has tree_limit or more triangles or vertices; the tree is that of an empty mesh

    std::size_t triangle_count() const { return triangles.size() / 3; }
    std::size_t bytes() const { return (nodes.size() + triangles.size()) * sizeof(Float4); }
};

// Builds the tree over all triangles of the mesh, whatever its topology. Nodes are split by the surface area heuristic
// (Wald 2007, with bins along the longest side), or at the median where the tree would otherwise become too deep.
// Triangles with a corner that is not finite, or with an index out of range, are left out.
Tree make_tree(const Mesh& mesh);

// One texel for each vertex, with w = 0. For a mesh without normals, a single texel of zeros.
std::vector<Float4> tree_normals(const Mesh& mesh);

}  // namespace snell::content
