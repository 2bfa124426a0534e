// Meshes on the CPU, which the runtime uploads. No GL.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/limits.h"

namespace snell::content {

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

}  // namespace snell::content
