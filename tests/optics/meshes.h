// Closed meshes to send rays through.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <glm/glm.hpp>

namespace snell::optics {

using std::numbers::pi;

struct Triangles {
    std::vector<glm::dvec3> positions;
    std::vector<std::uint32_t> indices;
};

// Of radius 1. Its positions are its normals.
inline Triangles ball_mesh(std::uint32_t slices, std::uint32_t stacks) {
    Triangles out;
    for (std::uint32_t j = 0; j <= stacks; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const double phi = 2 * pi * i / slices, theta = pi * j / stacks;
            const double ring = j == stacks ? 0 : std::sin(theta);  // a pole is one point
            out.positions.emplace_back(ring * std::cos(phi), std::cos(theta), -ring * std::sin(phi));
        }
    for (std::uint32_t j = 0; j < stacks; ++j)
        for (std::uint32_t i = 0; i < slices; ++i) {
            const std::uint32_t a = j * slices + i, b = j * slices + (i + 1) % slices;
            for (std::uint32_t v : {a, a + slices, b, b, a + slices, b + slices}) out.indices.push_back(v);
        }
    return out;
}

// A polygon in z = 0, counter-clockwise and convex, made a solid between z = -half and half.
inline Triangles prism_mesh(const std::vector<glm::dvec2>& polygon, double half) {
    Triangles out;
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (const double z : {-half, half})
        for (const glm::dvec2& p : polygon) out.positions.emplace_back(p, z);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        for (std::uint32_t v : {i, j, n + j, i, n + j, n + i}) out.indices.push_back(v);
        if (i == 0 || j == 0) continue;
        for (std::uint32_t v : {0U, j, i, n, n + i, n + j}) out.indices.push_back(v);
    }
    return out;
}

inline Triangles box_mesh(const glm::dvec3& half) {
    return prism_mesh({{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}, half.z);
}

// Around y, with radius 1 to the middle of a tube of radius `tube`.
inline Triangles torus_mesh(std::uint32_t around, std::uint32_t along, double tube) {
    Triangles out;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < along; ++j) {
            const double phi = 2 * pi * i / around, theta = 2 * pi * j / along, r = 1 + tube * std::cos(theta);
            out.positions.emplace_back(r * std::cos(phi), tube * std::sin(theta), -r * std::sin(phi));
        }
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t j = 0; j < along; ++j) {
            const std::uint32_t k = (i + 1) % around, l = (j + 1) % along;
            const std::uint32_t a = i * along + j, b = k * along + j, c = k * along + l, d = i * along + l;
            for (std::uint32_t v : {a, b, c, a, c, d}) out.indices.push_back(v);
        }
    return out;
}

}  // namespace snell::optics
