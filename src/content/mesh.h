// Geometry on the CPU: what the runtime uploads. No GL here.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "parser/limits.h"
#include "parser/scene.h"

namespace snell::content {

using Float3 = std::array<float, 3>;
using Float4 = std::array<float, 4>;

// A part of a mesh that is drawn with its own value of `uniform int FaceIndex` (the Soccerball's faces).
struct MeshPart {
    int face_index = 0;
    std::uint32_t first = 0, count = 0;  // of the indices
};

// Counter-clockwise front faces, outward unit normals. Attribute arrays are as long as `positions`, or empty
// where the mesh has none (texcoords: read as 0; tangents, colors: not offered).
struct Mesh {
    Topology topology = Topology::triangles;
    int patch_vertices = 3;  // of Topology::patches
    std::vector<Float3> positions;
    std::vector<float> w;  // only where some w of glVertex is not 1
    std::vector<Float3> normals;
    std::vector<Float3> texcoords;       // s, t, p
    std::vector<Float3> tangents;        // unit
    std::vector<Float4> colors;          // only from glColor
    std::vector<std::uint32_t> indices;  // always indexed
    std::vector<MeshPart> parts;         // none: one draw of all indices

    Float3 min{0, 0, 0}, max{0, 0, 0};  // bounds of the positions; see compute_bounds
    void compute_bounds();
    std::size_t bytes() const;
};

// What is odd about a mesh that was asked for; never fatal. For OBJ and shape files also what is wrong with
// the file.
struct MeshIssue {
    bool error = false;
    std::string code;  // stable, kebab-case
    std::string message;
    std::string help;
};

struct MeshLimits {
    std::size_t vertices = Limits{}.vertices;
    std::size_t file_bytes = Limits{}.file_bytes;
    std::size_t sub_quads = Limits{}.sub_quads;
};

struct MeshResult {
    Mesh mesh;  // empty when it can't be made; past a limit, of fewer vertices
    std::vector<MeshIssue> issues;
};

// Every Shape except the ones that read files or vertex lists. Parameters outside their domain are mended
// (slices below 3 …) and reported. `wire`: the same solid's edges as GL_LINES.
MeshResult make_shape(const Shape& shape, bool wire, const MeshLimits& limits = {});

MeshResult make_vertex_list(const VertexListData& list);

// `text` is the whole .obj. Missing normals are area-weighted averages at shared positions.
MeshResult parse_obj(std::string_view text, ObjAs as, bool wire, const MeshLimits& limits = {});

// Polylines of an ESRI shape file, as GL_LINES. `shp` is the whole .shp (the .shx is not needed).
MeshResult parse_shp(std::string_view shp, const MeshLimits& limits = {});

}  // namespace snell::content
