#include "tests/oracle/optics/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tests/oracle/optics/refraction.h"

namespace snell::optics {
namespace {

constexpr std::uint32_t leaf_size = 4;

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// The ray as the axis of the greatest component of its direction, and the shear that makes it one.
struct Sheared {
    glm::dvec3 origin;
    int x, y, z;
    double shear_x, shear_y, scale;

    explicit Sheared(const Ray& ray) : origin(ray.origin) {
        const glm::dvec3 a = glm::abs(ray.direction);
        z = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        scale = 1.0 / ray.direction[z];
        shear_x = ray.direction[x] * scale;
        shear_y = ray.direction[y] * scale;
    }
    glm::dvec3 apply(const glm::dvec3& point) const {
        const glm::dvec3 p = point - origin;
        return {p[x] - shear_x * p[z], p[y] - shear_y * p[z], p[z] * scale};
    }
};

std::optional<MeshHit> meet_triangle(const Sheared& ray, const glm::dvec3* corner, double after, double before,
                                     Facing facing) {
    const glm::dvec3 a = ray.apply(corner[0]), b = ray.apply(corner[1]), c = ray.apply(corner[2]);
    const glm::dvec3 w(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x, b.x * a.y - b.y * a.x);
    const bool negative = w.x < 0 || w.y < 0 || w.z<0, positive = w.x> 0 || w.y > 0 || w.z > 0;
    const double sum = w.x + w.y + w.z;
    if ((negative && positive) || sum == 0.0) return std::nullopt;
    const bool front = (sum < 0.0) == (ray.scale < 0.0);
    if (facing != Facing::both && front != (facing == Facing::front)) return std::nullopt;
    const double distance = (w.x * a.z + w.y * b.z + w.z * c.z) / sum;
    if (!(distance > after) || !(distance < before)) return std::nullopt;
    return MeshHit{distance, 0, w / sum, front};
}

// Whether the box is touched between the two distances. It is widened by more than the shear rounds, so that no
// triangle in it is lost.
bool touches(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high, double after, double before) {
    const glm::dvec3 size = glm::max(glm::abs(low), glm::abs(high)) + glm::abs(ray.origin);
    const double slack = 1e-14 * std::max({size.x, size.y, size.z});
    double enter = after, leave = before;
    for (int axis = 0; axis < 3; ++axis) {
        const double to_low = low[axis] - slack - ray.origin[axis], to_high = high[axis] + slack - ray.origin[axis];
        const double d = ray.direction[axis];
        if (d == 0.0) {
            if (to_low > 0.0 || to_high < 0.0) return false;
            continue;
        }
        enter = std::max(enter, std::min(to_low / d, to_high / d) * (1.0 - 1e-15));
        leave = std::min(leave, std::max(to_low / d, to_high / d) * (1.0 + 1e-15));
    }
    return enter <= leave;
}

}  // namespace

MeshTracer::MeshTracer(std::span<const glm::dvec3> positions, std::span<const std::uint32_t> indices) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> v = {indices[i], indices[i + 1], indices[i + 2]};
        const bool usable =
            std::ranges::all_of(v, [&](std::uint32_t at) { return at < positions.size() && finite(positions[at]); });
        if (usable) order_.push_back(static_cast<std::uint32_t>(i / 3));
        for (std::uint32_t at : v) corners_.push_back(usable ? positions[at] : glm::dvec3(0.0));
    }
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t MeshTracer::build(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Node node{glm::dvec3(infinity), glm::dvec3(-infinity), first, count};
    for (std::uint32_t i = first; i < first + count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            node.low = glm::min(node.low, corners_[order_[i] * 3 + k]);
            node.high = glm::max(node.high, corners_[order_[i] * 3 + k]);
        }
    nodes_.push_back(node);
    if (count <= leaf_size) return index;

    const glm::dvec3 size = node.high - node.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto middle = [&](std::uint32_t t) {
        return corners_[t * 3][axis] + corners_[t * 3 + 1][axis] + corners_[t * 3 + 2][axis];
    };
    std::nth_element(order_.begin() + first, order_.begin() + first + half, order_.begin() + first + count,
                     [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
    build(first, half);
    const std::uint32_t second = build(first + half, count - half);
    nodes_[index].first = second;
    nodes_[index].count = 0;
    return index;
}

std::optional<MeshHit> MeshTracer::nearest(const Ray& ray, double after, Facing facing) const {
    if (nodes_.empty() || !unit(ray.direction) || !finite(ray.origin)) return std::nullopt;
    const Sheared sheared(ray);
    std::optional<MeshHit> best;
    double before = std::numeric_limits<double>::infinity();
    std::vector<std::uint32_t> waiting = {0};
    while (!waiting.empty()) {
        const std::uint32_t at = waiting.back();
        waiting.pop_back();
        const Node& node = nodes_[at];
        if (!touches(ray, node.low, node.high, after, before)) continue;
        if (node.count == 0) {
            waiting.push_back(node.first);
            waiting.push_back(at + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            auto hit = meet_triangle(sheared, &corners_[order_[i] * 3], after, before, facing);
            if (!hit) continue;
            hit->triangle = order_[i];
            before = hit->distance;
            best = hit;
        }
    }
    return best;
}

glm::dvec3 MeshTracer::face_normal(std::size_t triangle) const {
    const glm::dvec3* corner = &corners_[triangle * 3];
    return glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
}

double MeshTracer::extent() const {
    if (nodes_.empty()) return 0.0;
    const glm::dvec3 size = glm::max(glm::abs(nodes_[0].low), glm::abs(nodes_[0].high));
    return std::max({size.x, size.y, size.z});
}

glm::dvec3 MeshTracer::point(std::size_t triangle, const glm::dvec3& weights) const {
    const glm::dvec3* corner = &corners_[triangle * 3];
    return weights.x * corner[0] + weights.y * corner[1] + weights.z * corner[2];
}

}  // namespace snell::optics
