#include "src/content/mesh/mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "src/content/bits.h"
#include "src/content/mesh/surface.h"

namespace snell::content {
namespace {

using Issues = std::vector<MeshIssue>;

void warn(Issues& issues, std::string code, std::string message, std::string help = {}) {
    issues.push_back({false, std::move(code), std::move(message), std::move(help)});
}
void fail(Issues& issues, std::string code, std::string message, std::string help = {}) {
    issues.push_back({true, std::move(code), std::move(message), std::move(help)});
}

// ---- mending of parameters ---------------------------------------------------------------------------

void at_least(int& count, int least, std::string_view what, Issues& issues) {
    if (count >= least) return;
    warn(issues, fmt::format("too-few-{}", what), fmt::format("{} {} are too few; {} are used", count, what, least));
    count = least;
}

// Reports an error and returns false if the shape cannot be made.
bool finite(double value, std::string_view what, Issues& issues) {
    if (std::abs(value) <= 1e37) return true;
    fail(issues, "size-not-finite", fmt::format("the {} {} is too large or not a number", what, value),
         "give a size between -1e37 and 1e37");
    return false;
}

bool positive(double& value, std::string_view what, Issues& issues) {
    if (!finite(value, what, issues)) return false;
    if (value < 0) {
        warn(issues, "negative-size", fmt::format("the {} {} is negative; {} is used", what, value, -value));
        value = -value;
    }
    if (value == 0)
        warn(issues, "zero-size", fmt::format("the {} is 0, so the shape is invisible", what), "give a size above 0");
    return true;
}

// Halves the largest count until the product of all (count + 1) fits.
template <std::size_t N>
void fit(const std::array<int*, N>& counts, const MeshLimits& limits, Issues& issues, bool quads = false) {
    const auto product = [&] {
        double p = 1;
        for (const int* c : counts) p *= static_cast<double>(*c) + 1;
        return p;
    };
    const double asked = product();
    // Indices must fit in 32 bits, with at most six for each vertex.
    const std::uint64_t limit = quads ? std::min(limits.vertices, limits.sub_quads) : limits.vertices;
    const double most = static_cast<double>(std::clamp<std::uint64_t>(limit, 1024, 500'000'000));
    while (product() > most) {
        int* largest = *std::max_element(counts.begin(), counts.end(), [](int* a, int* b) { return *a < *b; });
        *largest /= 2;
    }
    if (product() < asked)
        fail(issues, "too-many-vertices",
             fmt::format("{:.0f} vertices are too many; {:.0f} are used", asked, product()),
             limit_help(limit, limit < limits.vertices ? &Limits::sub_quads : &Limits::vertices));
}

// ---- each shape: parameters into their domain, then make it ------------------------------------------

struct Maker {
    bool wire;
    const MeshLimits& limits;
    Issues& issues;

    Mesh operator()(Sphere s) const {
        if (!positive(s.radius, "radius", issues)) return {};
        at_least(s.slices, 3, "slices", issues);
        at_least(s.stacks, 2, "stacks", issues);
        fit(std::array{&s.slices, &s.stacks}, limits, issues);
        return make_sphere(s, wire);
    }

    // Scenes give the two radii in either order; the larger one is the ring's.
    Mesh operator()(Torus s) const {
        if (!positive(s.outer, "outer radius", issues) || !positive(s.inner, "inner radius", issues)) return {};
        if (s.inner > s.outer) std::swap(s.inner, s.outer);
        if (s.inner == s.outer) warn(issues, "torus-without-hole", "both radii are equal: the torus has no hole");
        at_least(s.sides, 3, "sides", issues);
        at_least(s.rings, 3, "rings", issues);
        fit(std::array{&s.sides, &s.rings}, limits, issues);
        return make_torus(s, wire);
    }

    template <class Standing>
    bool mend_standing(Standing& s) const {
        if (!positive(s.radius, "radius", issues) || !finite(s.height, "height", issues)) return false;
        if (s.height == 0) warn(issues, "zero-size", "the height is 0; only the flat caps are drawn");
        at_least(s.slices, 3, "slices", issues);
        at_least(s.stacks, 1, "stacks", issues);
        int rows = s.stacks + std::min(4, std::numeric_limits<int>::max() - s.stacks);  // including those of the caps
        fit(std::array{&s.slices, &rows}, limits, issues);
        s.stacks = std::clamp(rows - 4, 1, s.stacks);
        return true;
    }
    Mesh operator()(Cone s) const { return mend_standing(s) ? make_cone(s, wire) : Mesh{}; }
    Mesh operator()(Cylinder s) const { return mend_standing(s) ? make_cylinder(s, wire) : Mesh{}; }

    Mesh operator()(Box s) const {
        if (!positive(s.dx, "length along x", issues) || !positive(s.dy, "length along y", issues) ||
            !positive(s.dz, "length along z", issues))
            return {};
        return make_box(s, wire);
    }

    Mesh operator()(const Teapot&) const { return make_teapot(wire); }

    Mesh operator()(Disk s) const {
        if (!finite(s.z, "z", issues) || !positive(s.radius, "radius", issues)) return {};
        at_least(s.slices, 3, "slices", issues);
        at_least(s.rings, 1, "rings", issues);
        fit(std::array{&s.slices, &s.rings}, limits, issues);
        return make_disk(s, wire);
    }

    Mesh operator()(Quad s) const {
        if (!finite(s.offset, "offset", issues) || !positive(s.size, "size", issues)) return {};
        at_least(s.n1, 1, "cells", issues);
        at_least(s.n2, 1, "cells", issues);
        fit(std::array{&s.n1, &s.n2}, limits, issues, true);
        return make_quad(s, wire);
    }

    Mesh operator()(QuadBox s) const {
        at_least(s.n, 1, "quads", issues);
        int corners = 3;  // four for a quad
        fit(std::array{&s.n, &corners}, limits, issues, true);
        return make_quad_box(s, wire);
    }

    Mesh operator()(Soccerball s) const {
        if (!positive(s.radius, "radius", issues)) return {};
        return make_soccerball(s, wire);
    }

    Mesh operator()(PointCloud s) const {
        at_least(s.nx, 1, "points", issues);
        at_least(s.ny, 1, "points", issues);
        at_least(s.nz, 1, "points", issues);
        fit(std::array{&s.nx, &s.ny, &s.nz}, limits, issues);
        return make_cloud(s);
    }

    Mesh operator()(Xarrow s) const {
        at_least(s.n, 2, "slices", issues);
        int around = 24;
        fit(std::array{&s.n, &around}, limits, issues);
        return make_xarrow(s, wire);
    }

    Mesh no_data() const {
        fail(issues, "shape-needs-data", "this shape's vertices come from a file or a list");
        return {};
    }
    Mesh operator()(const ObjFile&) const { return no_data(); }
    Mesh operator()(const ShpFile&) const { return no_data(); }
    Mesh operator()(const VertexList&) const { return no_data(); }
};

constexpr std::uint32_t empty = ~std::uint32_t{0};

std::uint64_t mix(std::uint64_t x) {  // the finaliser of splitmix64
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
}

std::uint64_t hash(const Float3& p) {
    // Adding 0 turns -0 into 0.
    const auto bits = [](float x) { return std::uint64_t{bits_as<std::uint32_t>(x + 0.f)}; };
    return mix(mix(bits(p[0]) | bits(p[1]) << 32) ^ bits(p[2]));
}

std::size_t table_size(std::size_t entries) { return std::bit_ceil(entries * 2 + 1); }

Float3 narrow(const Vec3& v) { return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])}; }

// Normalises `v`; a vector without direction becomes +Z.
Float3 unit(const Vec3& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    if (!(length > 0) || !std::isfinite(length)) return {0, 0, 1};
    return narrow({v[0] / length, v[1] / length, v[2] / length});
}

// An edge of a triangle. `edge` combines its two places in ascending order.
struct Half {
    std::uint64_t edge = 0;
    std::uint32_t corner = 0;  // index into the triangle list at which the edge begins
    bool reversed = false;     // runs from the higher place to the lower
};

std::uint32_t next_corner(std::uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
std::uint32_t far_corner(std::uint32_t corner) { return next_corner(next_corner(corner)); }

std::vector<Half> sorted_halves(std::span<const std::uint32_t> triangles, const Weld& weld) {
    std::vector<Half> halves(triangles.size());
    for (std::uint32_t c = 0; c < triangles.size(); ++c) {
        const std::uint32_t from = weld.place[triangles[c]], to = weld.place[triangles[next_corner(c)]];
        halves[c] = {std::uint64_t{std::min(from, to)} << 32 | std::max(from, to), c, from > to};
    }
    std::sort(halves.begin(), halves.end(), [](const Half& a, const Half& b) {
        if (a.edge != b.edge) return a.edge < b.edge;
        if (a.reversed != b.reversed) return b.reversed;
        return a.corner < b.corner;
    });
    return halves;
}

// The partner of the k-th edge of `own`, which all join the same places in the same direction; those of `other` run in
// the opposite direction.
const Half& partner(std::span<const Half> own, std::span<const Half> other, std::size_t k) {
    if (k < other.size()) return other[k];
    if (!other.empty()) return other[0];
    return own[(k + 1) % own.size()];  // an edge at a border is alone and is its own partner
}

}  // namespace

void Mesh::compute_bounds() {
    min = max = {0, 0, 0};
    bool first = true;
    for (const Float3& p : positions) {
        if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            min[k] = first ? p[k] : std::min(min[k], p[k]);
            max[k] = first ? p[k] : std::max(max[k], p[k]);
        }
        first = false;
    }
}

std::size_t Mesh::bytes() const {
    return (positions.size() + normals.size() + texcoords.size() + tangents.size()) * sizeof(Float3) +
           w.size() * sizeof(float) + colors.size() * sizeof(Float4) + indices.size() * sizeof(std::uint32_t) +
           parts.size() * sizeof(MeshPart);
}

MeshResult make_shape(const Shape& shape, bool wire, const MeshLimits& limits) {
    MeshResult result;
    result.mesh = std::visit(Maker{wire, limits, result.issues}, shape);
    return result;
}

std::vector<std::uint32_t> with_adjacency(std::span<const std::uint32_t> triangles, const Weld& weld,
                                          std::size_t* border_edges, std::size_t* crowded_edges) {
    std::vector<std::uint32_t> result(triangles.size() * 2);
    for (std::size_t c = 0; c < triangles.size(); ++c) result[2 * c] = triangles[c];

    const std::vector<Half> halves = sorted_halves(triangles, weld);
    for (auto begin = halves.begin(); begin != halves.end();) {
        const auto end = std::find_if(begin, halves.end(), [&](const Half& h) { return h.edge != begin->edge; });
        const auto split = std::find_if(begin, end, [](const Half& h) { return h.reversed; });
        const std::span<const Half> along(&*begin, static_cast<std::size_t>(split - begin));
        const std::span<const Half> against(along.data() + along.size(), static_cast<std::size_t>(end - split));
        for (std::size_t k = 0; k < along.size(); ++k)
            result[2 * along[k].corner + 1] = triangles[far_corner(partner(along, against, k).corner)];
        for (std::size_t k = 0; k < against.size(); ++k)
            result[2 * against[k].corner + 1] = triangles[far_corner(partner(against, along, k).corner)];
        if (border_edges && end - begin == 1) ++*border_edges;
        if (crowded_edges && (end - begin > 2 || along.size() == 2 || against.size() == 2)) ++*crowded_edges;
        begin = end;
    }
    return result;
}

Weld weld(std::span<const Float3> positions) {
    Weld result;
    result.place.resize(positions.size());
    std::vector<std::uint32_t> table(table_size(positions.size()), empty);  // index of the first vertex of each place
    const std::size_t mask = table.size() - 1;
    for (std::uint32_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & mask;
        while (table[slot] != empty && positions[table[slot]] != positions[i]) slot = (slot + 1) & mask;
        if (table[slot] == empty) {
            table[slot] = i;
            result.place[i] = result.places++;
        } else {
            result.place[i] = result.place[table[slot]];
        }
    }
    return result;
}

void keep_each_edge_once(std::vector<std::uint32_t>& lines, const Weld& weld) {
    constexpr std::uint64_t none64 = ~std::uint64_t{0};
    std::vector<std::uint64_t> table(table_size(lines.size() / 2), none64);
    const std::size_t mask = table.size() - 1;
    std::size_t kept = 0;
    for (std::size_t i = 0; i + 1 < lines.size(); i += 2) {
        const auto [low, high] = std::minmax(weld.place[lines[i]], weld.place[lines[i + 1]]);
        const std::uint64_t key = std::uint64_t{high} << 32 | low;
        std::size_t slot = mix(key) & mask;
        while (table[slot] != none64 && table[slot] != key) slot = (slot + 1) & mask;
        if (table[slot] == key) continue;
        table[slot] = key;
        const std::array pair{lines[i], lines[i + 1]};
        lines[kept++] = pair[0];
        lines[kept++] = pair[1];
    }
    lines.resize(kept);
}

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
