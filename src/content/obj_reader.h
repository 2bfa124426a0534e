// What a Wavefront .obj says, before it becomes a mesh. Internal to content/.
#pragma once

#include <span>

#include "src/content/mesh.h"

namespace snell::content {

// Indices from 0; -1: not given.
struct ObjCorner {
    std::int32_t position = -1, texcoord = -1, normal = -1;
};

struct ObjData {
    std::vector<Float3> positions, texcoords, normals;
    std::vector<ObjCorner> corners;               // of all faces, in the file's order
    std::vector<std::uint32_t> face_ends;         // face k's corners end here; it begins where face k - 1 ends
    std::vector<std::array<ObjCorner, 2>> lines;  // of `l` elements
};

// Through tinyobjloader's callbacks, which give faces as they stand in the file: one bad index costs its
// face, not the file. Faces that can't be drawn are left out and reported; every index in the result is in
// range and every position it names is finite. Numbers are read the same in every locale.
ObjData read_obj(std::string_view text, const MeshLimits& limits, std::vector<MeshIssue>& issues);

// Triangles (three corner numbers each) that cover a planar or nearly planar polygon, concave ones too, with
// the polygon's winding. `corners` are numbers below `positions`' size; appended to `triangles`.
void triangulate(std::span<const Float3> positions, std::vector<std::uint32_t>& triangles);

}  // namespace snell::content
