// The contents of a Wavefront .obj file, before they become a mesh. Internal to src/content.
#pragma once

#include <span>

#include "src/content/mesh/mesh.h"

namespace snell::content {

// Indices are 0-based; -1 if not given.
struct ObjCorner {
    std::int32_t position = -1, texcoord = -1, normal = -1;
};

struct ObjData {
    std::vector<Float3> positions, texcoords, normals;
    std::vector<ObjCorner> corners;  // of all faces, in the order of the file
    // Face k has the corners from face_ends[k - 1] (0 for the first face) up to face_ends[k].
    std::vector<std::uint32_t> face_ends;
    std::vector<std::array<ObjCorner, 2>> lines;  // the segments of `l` elements
};

// Reads the file through tinyobjloader's callbacks, which report each face separately: a bad index costs only its face.
// Faces that cannot be drawn are left out and reported. Every index in the result is in range, and every position that
// it refers to is finite. Numbers are read independent of the locale.
ObjData read_obj(std::string_view text, const MeshLimits& limits, std::vector<MeshIssue>& issues);

// Triangulates a planar or nearly planar polygon, which may be concave, with the polygon's winding. Appends three
// corner numbers for each triangle to `triangles`; a corner number is an index into `positions`.
void triangulate(std::span<const Float3> positions, std::vector<std::uint32_t>& triangles);

}  // namespace snell::content
