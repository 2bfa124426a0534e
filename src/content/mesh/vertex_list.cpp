#include <algorithm>
#include <cmath>

#include "src/content/mesh/mesh.h"

namespace snell::content {
namespace {

Float3 narrow(const Vec3& v) { return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])}; }

// Normalises `v`; a vector without direction becomes +Z.
Float3 unit(const Vec3& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 1};
    return narrow({v[0] / length, v[1] / length, v[2] / length});
}

}  // namespace

MeshResult make_vertex_list(const VertexListData& list) {
    MeshResult result;
    Mesh& mesh = result.mesh;
    mesh.topology = list.topology;
    mesh.patch_vertices = std::max(list.patch_vertices, 1);
    const bool has_w =
        std::any_of(list.vertices.begin(), list.vertices.end(), [](const ListVertex& v) { return v.position[3] != 1; });
    for (const ListVertex& v : list.vertices) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(narrow({v.position[0], v.position[1], v.position[2]}));
        mesh.normals.push_back(unit(v.normal));
        mesh.texcoords.push_back(narrow(v.texcoord));
        if (has_w) mesh.w.push_back(static_cast<float>(v.position[3]));
        if (list.has_color)
            mesh.colors.push_back({static_cast<float>(v.color[0]), static_cast<float>(v.color[1]),
                                   static_cast<float>(v.color[2]), static_cast<float>(v.color[3])});
    }
    mesh.compute_bounds();
    return result;
}

}  // namespace snell::content
