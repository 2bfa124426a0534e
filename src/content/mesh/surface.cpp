#include "src/content/mesh/surface.h"

#include <cmath>
#include <numbers>

#include "parser/vectors.h"

namespace snell::content {

Float3 to_float3(const Vec3& v) {
    return {static_cast<float>(v[0]) + 0.f, static_cast<float>(v[1]) + 0.f, static_cast<float>(v[2]) + 0.f};
}

Float3 unit_float3(const Vec3& v) {
    const double size = length(v);
    return size > 0 && std::isfinite(size) ? to_float3(divided(v, size)) : Float3{0, 0, 0};
}

void Surface::reserve(std::size_t vertices, std::size_t quads) {
    mesh_.positions.reserve(vertices);
    mesh_.normals.reserve(vertices);
    mesh_.texcoords.reserve(vertices);
    mesh_.indices.reserve(quads * (wire_ ? 8 : 6));
}

std::uint32_t Surface::vertex(const Vec3& position, const Vec3& normal, const Vec3& texcoord) {
    mesh_.positions.push_back(to_float3(position));
    mesh_.normals.push_back(unit_float3(normal));
    mesh_.texcoords.push_back(to_float3(texcoord));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void Surface::tangent(const Vec3& tangent) { mesh_.tangents.push_back(unit_float3(tangent)); }

void Surface::edge(std::uint32_t a, std::uint32_t b) {
    if (!same(a, b)) mesh_.indices.insert(mesh_.indices.end(), {a, b});
}

void Surface::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (wire_) {
        edge(a, b);
        edge(b, c);
        edge(c, a);
    } else if (!same(a, b) && !same(b, c) && !same(c, a)) {
        for (const std::uint32_t corner : {a, b, c}) mesh_.indices.push_back(corner);
    }
}

void Surface::quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    if (wire_) {
        edge(a, b);
        edge(b, c);
        edge(c, d);
        edge(d, a);
    } else {
        triangle(a, b, c);
        triangle(a, c, d);
    }
}

void Surface::part(int face_index) {
    close_part();
    mesh_.parts.push_back({face_index, static_cast<std::uint32_t>(mesh_.indices.size()), 0});
}

void Surface::close_part() {
    if (mesh_.parts.empty()) return;
    MeshPart& last = mesh_.parts.back();
    last.count = static_cast<std::uint32_t>(mesh_.indices.size()) - last.first;
}

Mesh Surface::finish() && {
    if (wire_)
        keep_each_edge_once(mesh_.indices, weld(mesh_.positions));
    else
        close_part();
    if (wire_) mesh_.parts.clear();
    mesh_.compute_bounds();
    return std::move(mesh_);
}

std::vector<SinCos> circle(int n) {
    std::vector<SinCos> table(static_cast<std::size_t>(n) + 1);
    for (int k = 0; k < n; ++k) {
        const std::int64_t quarter = std::int64_t{4} * k / n, rest = std::int64_t{4} * k - quarter * n;
        const double angle = static_cast<double>(rest) / n * (std::numbers::pi / 2);
        // Angles are measured from the nearer end of the quadrant, so that mirror images are equal to the bit.
        const double other = static_cast<double>(n - rest) / n * (std::numbers::pi / 2);
        const double s = 2 * rest <= n ? std::sin(angle) : std::cos(other);
        const double c = 2 * rest <= n ? std::cos(angle) : std::sin(other);
        const std::array<SinCos, 4> turned{{{s, c}, {c, -s}, {-s, -c}, {-c, s}}};
        table[static_cast<std::size_t>(k)] = turned[static_cast<std::size_t>(quarter)];
    }
    table.back() = table.front();
    return table;
}

void revolve(Surface& surface, int slices, std::span<const Ring> rings, bool tangents) {
    const std::vector<SinCos> around = circle(slices);
    surface.reserve((static_cast<std::size_t>(slices) + 1) * rings.size(),
                    static_cast<std::size_t>(slices) * rings.size());
    surface.grid(slices, static_cast<int>(rings.size()) - 1, [&](int i, int j) {
        const SinCos a = around[static_cast<std::size_t>(i)];
        const Ring& r = rings[static_cast<std::size_t>(j)];
        surface.vertex({-a.cos * r.radius, r.y, a.sin * r.radius},
                       {-a.cos * r.normal_radial, r.normal_y, a.sin * r.normal_radial},
                       {static_cast<double>(i) / slices, r.t, 0});
        // The tangent is perpendicular to the normal in the half plane of this slice. This holds at a pole too, because
        // each slice has its own vertex there.
        if (tangents) surface.tangent({a.cos * r.normal_y, r.normal_radial, -a.sin * r.normal_y});
    });
}

}  // namespace snell::content
