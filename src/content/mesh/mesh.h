// Meshes of triangles: vertices that are welded, neighbours of edges.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/limits.h"

namespace snell::content {

// Meshes on the CPU, which the runtime uploads. No GL.

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

// A part of a mesh with its own value of `uniform int FaceIndex`, such as a face of the Soccerball.
struct MeshPart {
    int face_index = 0;
    std::uint32_t first = 0, count = 0;  // range of the indices
};

// A mesh with counter-clockwise front faces and outward unit normals. Attribute arrays are as long as `positions`, or
// empty if the mesh does not have them (shaders then read texcoords as 0, and have no tangents or colors).
struct Mesh {
    Topology topology = Topology::triangles;
    int patch_vertices = 3;  // for Topology::patches
    std::vector<Float3> positions;
    std::vector<float> w;  // empty unless some w of glVertex is not 1
    std::vector<Float3> normals;
    std::vector<Float3> texcoords;       // s, t, p
    std::vector<Float3> tangents;        // unit vectors
    std::vector<Float4> colors;          // present only if set by glColor
    std::vector<std::uint32_t> indices;  // always used: every mesh is indexed
    std::vector<MeshPart> parts;         // empty: one draw of all indices

    Float3 min{0, 0, 0}, max{0, 0, 0};  // bounds of the positions, set by compute_bounds()
    void compute_bounds();
    std::size_t bytes() const;
};

// A problem with a requested mesh or its file.
struct MeshIssue {
    bool error = false;
    std::string code;  // stable, in kebab-case
    std::string message;
    std::string help;
    bool note = false;  // not an error, and nothing that the picture shows
};

struct MeshLimits {
    std::uint64_t vertices = Limits{}.vertices;
    std::uint64_t file_bytes = Limits{}.file_bytes;
    std::uint64_t sub_quads = Limits{}.sub_quads;
};

struct MeshResult {
    Mesh mesh;  // empty if it cannot be made; with reduced vertex counts if it exceeded a limit
    std::vector<MeshIssue> issues;
};

// Makes every Shape that does not read a file or a vertex list. Parameters outside of their domain (such as slices
// below 3) are corrected and reported. With `wire`, makes the edges of the same solid as GL_LINES.
MeshResult make_shape(const Shape& shape, bool wire, const MeshLimits& limits = {});

// Makes the mesh of a list of vertices (glBegin … glEnd, Triangles, LinesAdjacency).
MeshResult make_vertex_list(const VertexListData& list);

// Parses a whole .obj file. Missing normals are computed as area-weighted averages over the faces at a position.
MeshResult parse_obj(std::string_view text, ObjAs as, bool wire, const MeshLimits& limits = {});

// Parses the polylines of an ESRI shape file as GL_LINES. `shp` is the whole .shp file; the .shx is not needed.
MeshResult parse_shp(std::string_view shp, const MeshLimits& limits = {});

// Finds vertices at the same place. Internal to src/content.

// For each position, the number of its place. Equal positions have equal numbers, which count from 0 in the order of
// first appearance. 0 and -0 are equal; NaN equals nothing.
struct Weld {
    std::vector<std::uint32_t> place;  // as long as the positions
    std::uint32_t places = 0;
};
Weld weld(std::span<const Float3> positions);

// Removes pairs of indices that join the same two places as an earlier pair, in either direction; the order of the
// others stays.
void keep_each_edge_once(std::vector<std::uint32_t>& lines, const Weld& weld);

// Neighbours of triangles, for geometry shaders. Internal to src/content.

// Converts indices of GL_TRIANGLES to those of GL_TRIANGLES_ADJACENCY (v0 n01 v1 n12 v2 n20), where n01 is the opposite
// corner of the triangle across the edge v0 v1. Vertices at the same place count as one, whatever their normals and
// texture coordinates. At a border there is no neighbour; the triangle's own opposite corner is used, as if it were
// folded back. If an edge belongs to several triangles, they are paired in order: the k-th that runs along the edge in
// one direction with the k-th that runs in the other. One without a partner takes the first of the other direction or,
// if all run in the same direction, the next one.
std::vector<std::uint32_t> with_adjacency(std::span<const std::uint32_t> triangles, const Weld& weld,
                                          std::size_t* border_edges = nullptr, std::size_t* crowded_edges = nullptr);

}  // namespace snell::content
