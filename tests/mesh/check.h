// Facts about meshes that any right one has to show.
#pragma once

#include "src/content/mesh/mesh.h"
#include "tests/std.h"

namespace snell::content::check {

inline constexpr double pi = std::numbers::pi;

using D3 = std::array<double, 3>;

inline D3 wide(const Float3& v) { return {v[0], v[1], v[2]}; }
inline D3 minus(const D3& a, const D3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline double dot(const D3& a, const D3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline D3 cross(const D3& a, const D3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const D3& a) { return std::sqrt(dot(a, a)); }

inline D3 corner(const Mesh& m, std::size_t i) { return wide(m.positions[m.indices[i]]); }
inline D3 area_vector(const Mesh& m, std::size_t first) {  // of the triangle
    const D3 a = corner(m, first);
    const D3 n = cross(minus(corner(m, first + 1), a), minus(corner(m, first + 2), a));
    return {n[0] / 2, n[1] / 2, n[2] / 2};
}

inline double area(const Mesh& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) sum += length(area_vector(m, i));
    return sum;
}

// By the divergence theorem; positive if the triangles face outward.
inline double volume(const Mesh& m) {
    double sum = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) sum += dot(corner(m, i), area_vector(m, i)) / 3;
    return sum;
}

// Area of a convex solid's shadow along `axis`.
inline double shadow(const Mesh& m, std::size_t axis) {
    double sum = 0;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) sum += std::abs(area_vector(m, i)[axis]) / 2;
    return sum;
}

// Vertices by place. -0 and 0 count as different on purpose: seams have to be equal bit for bit.
inline std::vector<int> places(const Mesh& m) {
    std::map<std::array<std::uint32_t, 3>, int> number;
    std::vector<int> result;
    for (const Float3& p : m.positions) {
        std::array<std::uint32_t, 3> bits;
        std::copy_n(reinterpret_cast<const unsigned char*>(p.data()), sizeof p,
                    reinterpret_cast<unsigned char*>(bits.data()));
        result.push_back(number.emplace(bits, static_cast<int>(number.size())).first->second);
    }
    return result;
}

// Edges that do not belong to exactly two triangles, which run along it in opposite directions.
inline int unpaired_edges(const Mesh& m) {
    const std::vector<int> place = places(m);
    std::map<std::pair<int, int>, int> halves;
    for (std::size_t i = 0; i < m.indices.size(); i += 3)
        for (std::size_t k = 0; k < 3; ++k) ++halves[{place[m.indices[i + k]], place[m.indices[i + (k + 1) % 3]]}];
    int wrong = 0;
    for (const auto& [edge, count] : halves) {
        const auto other = halves.find({edge.second, edge.first});
        wrong += count != 1 || other == halves.end() || other->second != 1 || edge.first == edge.second;
    }
    return wrong;
}

// Closed, without T-junctions and degenerate triangles, consistently wound.
inline void expect_closed(const Mesh& m) {
    EXPECT_EQ(unpaired_edges(m), 0) << "edges not shared by exactly two triangles in opposite directions";
}

// Unit normals on the outer side of the triangles, no index out of range, bounds right, all numbers finite.
inline void expect_sound(const Mesh& m, double least_cosine = 1e-3, bool with_areas = true) {
    ASSERT_FALSE(m.positions.empty());
    ASSERT_EQ(m.normals.size(), m.positions.size());
    ASSERT_EQ(m.texcoords.size(), m.positions.size());
    ASSERT_FALSE(m.indices.empty());
    for (const std::uint32_t i : m.indices) ASSERT_LT(i, m.positions.size());
    Float3 low = m.positions[0], high = low;
    for (std::size_t i = 0; i < m.positions.size(); ++i) {
        ASSERT_NEAR(length(wide(m.normals[i])), 1, 1e-6);
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_TRUE(std::isfinite(m.positions[i][k]) && std::isfinite(m.texcoords[i][k]));
            low[k] = std::min(low[k], m.positions[i][k]);
            high[k] = std::max(high[k], m.positions[i][k]);
        }
    }
    EXPECT_EQ(m.min, low);
    EXPECT_EQ(m.max, high);
    if (m.topology != Topology::triangles || !with_areas) return;
    for (std::size_t i = 0; i < m.indices.size(); i += 3) {
        const D3 face = area_vector(m, i);
        ASSERT_GT(length(face), 0) << "triangle " << i / 3;
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_GT(dot(face, wide(m.normals[m.indices[i + k]])) / length(face), least_cosine)
                << "triangle " << i / 3;
    }
}

inline Mesh made(const Shape& shape, bool wire = false) {
    MeshResult r = make_shape(shape, wire);
    for (const MeshIssue& issue : r.issues) ADD_FAILURE() << issue.code << ": " << issue.message;
    return std::move(r.mesh);
}

inline bool has_issue(const MeshResult& r, const std::string& code) {
    return std::any_of(r.issues.begin(), r.issues.end(), [&](const MeshIssue& i) { return i.code == code; });
}

// Undirected edges by place, and how many lines join each.
inline std::map<std::pair<int, int>, int> lines_by_place(const Mesh& wire) {
    const std::vector<int> place = places(wire);
    std::map<std::pair<int, int>, int> lines;
    for (std::size_t i = 0; i < wire.indices.size(); i += 2) {
        const auto [a, b] = std::minmax(place[wire.indices[i]], place[wire.indices[i + 1]]);
        ++lines[{a, b}];
    }
    return lines;
}

}  // namespace snell::content::check
