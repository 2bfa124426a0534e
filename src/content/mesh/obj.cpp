#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/content/mesh/mesh.h"
#include "src/content/mesh/obj_reader.h"

namespace snell::content {
namespace {

using Corners = std::array<std::uint32_t, 3>;  // indices into ObjData::corners
constexpr std::uint32_t no_vertex = ~std::uint32_t{0};

Vec3 wide(const Float3& v) { return {v[0], v[1], v[2]}; }
Float3 to_float3(const Vec3& v) {
    return {static_cast<float>(v[0]) + 0.f, static_cast<float>(v[1]) + 0.f, static_cast<float>(v[2]) + 0.f};
}

// Normalises `v`; zero if it has no direction.
Float3 unit_normal(const Vec3& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 0};
    return to_float3({v[0] / length, v[1] / length, v[2] / length});
}
bool is_zero(const Vec3& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

// A vector along the normal, of twice the triangle's area.
Vec3 area(const Float3& p0, const Float3& p1, const Float3& p2) {
    const Vec3 o = wide(p0), p = wide(p1), q = wide(p2);
    const Vec3 a{p[0] - o[0], p[1] - o[1], p[2] - o[2]}, b{q[0] - o[0], q[1] - o[1], q[2] - o[2]};
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

const Float3& position(const ObjData& data, std::uint32_t corner) {
    return data.positions[static_cast<std::size_t>(data.corners[corner].position)];
}

// Splits all faces into triangles and leaves out those with two corners at one place. `flat` counts those without area.
std::vector<Corners> triangles_of(const ObjData& data, std::size_t& flat) {
    std::vector<Corners> result;
    result.reserve(data.face_ends.size());
    std::vector<Float3> polygon;
    std::vector<std::uint32_t> cut;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : data.face_ends) {
        polygon.clear();
        cut.clear();
        for (std::uint32_t c = begin; c < end; ++c) polygon.push_back(position(data, c));
        triangulate(polygon, cut);
        for (std::size_t i = 0; i < cut.size(); i += 3) {
            const Float3 &a = polygon[cut[i]], &b = polygon[cut[i + 1]], &c = polygon[cut[i + 2]];
            if (is_zero(area(a, b, c))) ++flat;
            if (a != b && b != c && c != a) result.push_back({begin + cut[i], begin + cut[i + 1], begin + cut[i + 2]});
        }
        begin = end;
    }
    return result;
}

// Area-weighted normals by place. If the sum vanishes (the two sides of a sheet), the normal of the first triangle; if
// all triangles have no area, +Z.
std::vector<Float3> normals_by_place(const ObjData& data, const std::vector<Corners>& triangles, const Weld& places) {
    std::vector<Vec3> sum(places.places, Vec3{0, 0, 0}), first(places.places, Vec3{0, 0, 0});
    std::vector<double> total(places.places, 0);
    for (const Corners& t : triangles) {
        const Vec3 a = area(position(data, t[0]), position(data, t[1]), position(data, t[2]));
        if (is_zero(a)) continue;
        for (const std::uint32_t corner : t) {
            const std::uint32_t place = places.place[static_cast<std::size_t>(data.corners[corner].position)];
            if (is_zero(first[place])) first[place] = a;
            for (std::size_t k = 0; k < 3; ++k) sum[place][k] += a[k];
            total[place] += std::hypot(a[0], a[1], a[2]);
        }
    }
    std::vector<Float3> normals(places.places);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const bool cancelled = std::hypot(sum[i][0], sum[i][1], sum[i][2]) <= 1e-9 * total[i];
        normals[i] = unit_normal(cancelled ? first[i] : sum[i]);
        if (normals[i] == Float3{0, 0, 0}) normals[i] = {0, 0, 1};
    }
    return normals;
}

// Makes one vertex for all corners with the same indices.
class Vertices {
public:
    Vertices(const ObjData& data, Mesh& mesh, std::vector<Float3> computed, const Weld& places)
        : data_(data),
          mesh_(mesh),
          computed_(std::move(computed)),
          places_(places),
          head_(data.positions.size(), no_vertex) {}

    std::uint32_t operator()(ObjCorner c) {
        Float3 normal{0, 0, 0};
        if (c.normal >= 0) normal = unit_normal(wide(data_.normals[static_cast<std::size_t>(c.normal)]));
        if (normal == Float3{0, 0, 0}) c.normal = -1;
        const auto at = static_cast<std::size_t>(c.position);
        for (std::uint32_t v = head_[at]; v != no_vertex; v = made_[v].next)
            if (made_[v].texcoord == c.texcoord && made_[v].normal == c.normal) return v;
        const auto index = static_cast<std::uint32_t>(made_.size());
        made_.push_back({c.texcoord, c.normal, head_[at]});
        head_[at] = index;
        mesh_.positions.push_back(data_.positions[at]);
        mesh_.normals.push_back(c.normal < 0 ? computed_[places_.place[at]] : normal);
        mesh_.texcoords.push_back(c.texcoord < 0 ? Float3{0, 0, 0}
                                                 : data_.texcoords[static_cast<std::size_t>(c.texcoord)]);
        return index;
    }

private:
    struct Made {
        std::int32_t texcoord, normal;
        std::uint32_t next;  // another vertex at the same position
    };
    const ObjData& data_;
    Mesh& mesh_;
    std::vector<Float3> computed_;
    const Weld& places_;
    std::vector<std::uint32_t> head_;
    std::vector<Made> made_;
};

void add_wire(const ObjData& data, Vertices& vertex, Mesh& mesh) {
    mesh.topology = Topology::lines;
    std::uint32_t begin = 0;
    for (const std::uint32_t end : data.face_ends) {
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t next = c + 1 == end ? begin : c + 1;
            if (position(data, c) == position(data, next)) continue;
            const std::uint32_t a = vertex(data.corners[c]), b = vertex(data.corners[next]);
            mesh.indices.insert(mesh.indices.end(), {a, b});
        }
        begin = end;
    }
    for (const auto& line : data.lines) {
        const std::uint32_t a = vertex(line[0]), b = vertex(line[1]);
        if (mesh.positions[a] != mesh.positions[b]) mesh.indices.insert(mesh.indices.end(), {a, b});
    }
    keep_each_edge_once(mesh.indices, weld(mesh.positions));
}

void add_triangles(const ObjData& data, const std::vector<Corners>& triangles, ObjAs as, Vertices& vertex, Mesh& mesh,
                   std::vector<MeshIssue>& issues) {
    mesh.indices.reserve(triangles.size() * 3);
    for (const Corners& t : triangles)
        for (const std::uint32_t corner : t) mesh.indices.push_back(vertex(data.corners[corner]));
    if (as == ObjAs::patches) {
        mesh.topology = Topology::patches;
        mesh.patch_vertices = 3;
    } else if (as == ObjAs::adjacency) {
        mesh.topology = Topology::triangles_adjacency;
        std::size_t crowded = 0;
        mesh.indices = with_adjacency(mesh.indices, weld(mesh.positions), nullptr, &crowded);
        if (crowded > 0)
            issues.push_back(
                {false, "obj-not-manifold",
                 fmt::format("{} edges belong to more than two triangles, or to two with opposite winding", crowded),
                 "adjacency is ambiguous there; repair the mesh"});
    }
}

}  // namespace

MeshResult parse_obj(std::string_view text, ObjAs as, bool wire, const MeshLimits& limits) {
    MeshResult result;
    const ObjData data = read_obj(text, limits, result.issues);
    const auto failed = [&] {
        return std::any_of(result.issues.begin(), result.issues.end(), [](const MeshIssue& i) { return i.error; });
    };
    if (failed()) return result;

    std::size_t flat = 0;
    const std::vector<Corners> triangles = triangles_of(data, flat);
    if (flat > 0)
        result.issues.push_back({false, "obj-zero-area", fmt::format("{} triangles have zero area", flat),
                                 "nothing is drawn of them: the picture is the same without", true});

    const Weld places = weld(data.positions);
    Mesh& mesh = result.mesh;
    Vertices vertex(data, mesh, normals_by_place(data, triangles, places), places);
    if (wire)
        add_wire(data, vertex, mesh);
    else
        add_triangles(data, triangles, as, vertex, mesh, result.issues);

    if (mesh.indices.empty()) {
        result.issues.push_back(
            {true, "obj-no-faces", "the file contains no drawable faces", "faces are lines such as 'f 1 2 3'"});
        result.mesh = {};
    } else if (mesh.positions.size() > limits.vertices) {
        result.issues.push_back({true, "too-many-vertices",
                                 fmt::format("the mesh has {} vertices, more than the limit", mesh.positions.size()),
                                 limit_help(limits.vertices, &Limits::vertices)});
        result.mesh = {};
    }
    mesh.compute_bounds();
    return result;
}

}  // namespace snell::content
