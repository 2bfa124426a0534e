#include <algorithm>
#include <cmath>

#include "src/content/mesh/obj.h"

namespace snell::content {
namespace {

using Point = std::array<double, 2>;

// Ear clipping takes time quadratic in the number of corners at best, cubic at worst. Beyond these bounds a polygon is
// cut without looking for ears, which may cover parts of it twice.
constexpr std::size_t most_concave_corners = 20'000, most_point_tests = 50'000'000;

// Newell's method: a vector along the normal of twice the area, also for concave and slightly bent polygons.
std::array<double, 3> area_vector(std::span<const Float3> p) {
    std::array<double, 3> n{0, 0, 0};
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Float3 &a = p[i], &b = p[(i + 1) % p.size()];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
            n[k] += (double{a[u]} - b[u]) * (double{a[v]} + b[v]);
        }
    }
    return n;
}

// Projects along the largest component of the normal, so that the winding is counter-clockwise.
std::vector<Point> flatten(std::span<const Float3> p) {
    const auto n = area_vector(p);
    std::size_t k = 0;
    for (std::size_t i = 1; i < 3; ++i)
        if (std::abs(n[i]) > std::abs(n[k])) k = i;
    std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    if (n[k] < 0) std::swap(u, v);
    std::vector<Point> flat;
    flat.reserve(p.size());
    for (const Float3& q : p) flat.push_back({q[u], q[v]});
    return flat;
}

double turn(const Point& a, const Point& b, const Point& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool convex(const std::vector<Point>& p) {
    for (std::size_t i = 0; i < p.size(); ++i)
        if (turn(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) < 0) return false;
    return true;
}

void fan(std::size_t corners, std::vector<std::uint32_t>& triangles) {
    for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

// Ear clipping (Meisters 1975).
class Ears {
public:
    explicit Ears(const std::vector<Point>& points) : p_(points) {
        for (std::uint32_t i = 0; i < points.size(); ++i) left_.push_back(i);
    }

    void clip(std::vector<std::uint32_t>& triangles) {
        std::size_t i = 0, refused = 0;
        while (left_.size() > 3) {
            i %= left_.size();
            // A polygon that intersects itself may have no ear; then any corner is cut off.
            if (tests_ < most_point_tests && !ear(i) && refused++ < left_.size()) {
                ++i;
                continue;
            }
            triangles.insert(triangles.end(), {before(i), left_[i], after(i)});
            left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
            refused = 0;
        }
        triangles.insert(triangles.end(), left_.begin(), left_.end());
    }

private:
    std::uint32_t before(std::size_t i) const { return left_[(i + left_.size() - 1) % left_.size()]; }
    std::uint32_t after(std::size_t i) const { return left_[(i + 1) % left_.size()]; }

    bool ear(std::size_t i) {
        const Point &a = p_[before(i)], &b = p_[left_[i]], &c = p_[after(i)];
        if (turn(a, b, c) <= 0) return false;
        tests_ += left_.size();
        return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t k) {
            const Point& q = p_[k];
            if (q == a || q == b || q == c) return false;
            return turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
        });
    }

    const std::vector<Point>& p_;
    std::vector<std::uint32_t> left_;
    std::size_t tests_ = 0;
};

}  // namespace

void triangulate(std::span<const Float3> positions, std::vector<std::uint32_t>& triangles) {
    if (positions.size() == 3) {
        triangles.insert(triangles.end(), {0, 1, 2});
        return;
    }
    const std::vector<Point> flat = flatten(positions);
    if (convex(flat) || flat.size() > most_concave_corners)
        fan(flat.size(), triangles);
    else
        Ears(flat).clip(triangles);
}

}  // namespace snell::content
