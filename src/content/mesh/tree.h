// A bounding volume hierarchy over a mesh's triangles, as RGBA32F texels that shaders trace rays through
// (shaders/snell/mesh.glsl). No GL.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "src/content/mesh/mesh.h"

namespace snell::content {

// Indices are stored as floats, which are exact below this.
inline constexpr std::size_t tree_limit = std::size_t{1} << 24;
inline constexpr std::size_t tree_leaf = 4;  // maximum number of triangles in a leaf
// Maximum number of nodes from the root to a leaf, which bounds the traversal's stack.
inline constexpr std::size_t tree_depth = 32;
// Number of texels in a row of the textures that the lists below become: 2 to the power of SNELL_MESH_ROW of mesh.glsl.
// Every OpenGL takes textures of this width.
inline constexpr std::size_t tree_row = 1024;

struct Tree {
    // Two texels for each node: (low corner of the box, link) and (high corner, kind). If kind > 0, the node is a leaf
    // of that many triangles, and `link` is the first of them. Otherwise it has two children, separated along the axis
    // -kind - 1: the lower one is the next node, the other is `link`. A node without triangles has an inverted box. The
    // root is node 1. In the place of node 0 is the tree's frame: its origin in the model, and its scale. All
    // coordinates here are (model - origin) * scale, so that the mesh lies around 0 with a size near 1 and float
    // rounding is relative to its size. The origin is 0 for a mesh that lies near the model's. The scale is a power of
    // two, which rounds nothing.
    std::vector<Float4> nodes;
    // Three texels for each triangle, in the order of the leaves: each has a corner (counter-clockwise seen from
    // outside) and the number of its vertex in the mesh, or -1 if the vertex has no normal.
    std::vector<Float4> triangles;
    bool too_large = false;  // the mesh is at the limit or beyond; the tree is that of an empty mesh

    std::size_t triangle_count() const { return triangles.size() / 3; }
    std::size_t bytes() const { return (nodes.size() + triangles.size()) * sizeof(Float4); }
};

// Builds the tree over all triangles of the mesh, whatever its topology. Nodes are split by the surface area heuristic
// (Wald 2007, with bins along the longest side), or at the median where the tree would otherwise become too deep.
// Triangles with a corner that is not finite, or with an index out of range, are left out. A mesh of `limit` or more
// triangles or vertices is too large.
Tree make_tree(const Mesh& mesh, std::size_t limit = tree_limit);
// The limit where textures have at most that many rows. A tree has fewer than four texels for each triangle.
constexpr std::size_t limit_of_rows(std::size_t rows) { return std::min(tree_limit, rows * tree_row / 4); }

// One texel for each vertex, with w = 0. For a mesh without normals, a single texel of zeros.
std::vector<Float4> tree_normals(const Mesh& mesh);

// Fills the last row with zeros, and returns the width and height of the texture. Fewer texels than a row become a
// shorter one.
std::array<int, 2> fill_rows(std::vector<Float4>& texels);

}  // namespace snell::content
