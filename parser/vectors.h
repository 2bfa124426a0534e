// What is computed with vectors of three numbers, in any space.
#pragma once

#include <algorithm>
#include <cmath>

#include "parser/scene.h"

namespace snell {

constexpr Vec3 difference(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
constexpr Vec3 divided(const Vec3& v, double by) { return {v[0] / by, v[1] / by, v[2] / by}; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }
inline double largest(const Vec3& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

}  // namespace snell
