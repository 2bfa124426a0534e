// The domain of a patch, divided as OpenGL's tessellator divides it, for contexts that have none.
#pragma once

#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

namespace snell::content {

enum class Domain : std::uint8_t { triangles, quads, isolines };
enum class Spacing : std::uint8_t { equal, fractional_even, fractional_odd };

// The input layout of a tessellation evaluation shader.
struct Tessellator {
    Domain domain = Domain::triangles;
    Spacing spacing = Spacing::equal;
    bool clockwise = false;
    bool points = false;  // point_mode: each vertex once, and no triangles or lines
    bool operator==(const Tessellator&) const = default;
};

struct TessellationLevels {
    std::array<float, 4> outer{1, 1, 1, 1};
    std::array<float, 2> inner{1, 1};
    bool operator==(const TessellationLevels&) const = default;
    // Not by <=>, which not every standard library has for arrays yet.
    bool operator<(const TessellationLevels& other) const {
        return std::tie(outer, inner) < std::tie(other.outer, other.inner);
    }
};

// The least maximum that OpenGL allows, and the greatest level that counts here.
inline constexpr int most_tessellation = 64;

// Vertices are at u and v; the third coordinate of a triangle is 1 - u - v. All numbers are multiples of 1/65536, and
// places along an edge are symmetrical about its middle, so that patches that share an edge and its level meet exactly.
// The indices list points, lines or triangles. Empty where a level discards the patch.
struct DividedDomain {
    std::vector<std::array<float, 2>> vertices;
    std::vector<std::uint32_t> indices;
};
DividedDomain divide(const Tessellator& tessellator, const TessellationLevels& levels);

// How many vertices a primitive of the divided domain has.
inline int corners_of(const Tessellator& tessellator) {
    return tessellator.points ? 1 : tessellator.domain == Domain::isolines ? 2 : 3;
}

}  // namespace snell::content
