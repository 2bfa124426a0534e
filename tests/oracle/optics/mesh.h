// Rays against triangles, by a hierarchy of boxes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tests/oracle/optics/ray.h"

namespace snell::optics {

struct MeshHit {
    double distance = 0;  // along the ray, in units of its direction
    std::size_t triangle = 0;
    glm::dvec3 weights{0};  // of the triangle's corners; sum 1
    bool front = true;      // met from the side that sees the corners counter-clockwise
};

// Which side of a triangle a ray may meet.
enum class Facing { both, front, back };

// A copy of the triangles, and their hierarchy: built in n log n by halving at the median along the longest side, so
// its depth is at most log2(n) + 1 whatever the mesh.
class MeshTracer {
public:
    // Three indices a triangle; a rest of one or two is ignored. Triangles whose indices are out of range or whose
    // corners are not finite are never hit.
    MeshTracer(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> indices);

    // The nearest hit with distance > `after`. Watertight (Woop, Benthin and Wald 2013): corners
    // are sheared so that the ray becomes an axis, and an edge gives both its triangles the same sign, so no ray
    // slips between triangles that share their corners bit for bit. A triangle without area is never hit. nullopt:
    // none, or the direction is zero or not finite.
    std::optional<MeshHit> nearest(const Ray& ray, double after = 0.0, Facing facing = Facing::both) const;

    std::size_t triangles() const { return corners_.size() / 3; }
    // Not of unit length: twice the triangle's area, by the right hand from its first corner to the third.
    glm::dvec3 face_normal(std::size_t triangle) const;
    // The largest absolute coordinate of a corner that rays can meet; 0 for no triangles.
    double extent() const;
    // Of the triangle's corners, by weights that sum to 1.
    glm::dvec3 point(std::size_t triangle, const glm::dvec3& weights) const;

private:
    struct Node {
        glm::dvec3 low, high;
        std::uint32_t first = 0, count = 0;  // of order_; count 0: the children are the next node and `first`
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<glm::dvec3> corners_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

}  // namespace snell::optics
