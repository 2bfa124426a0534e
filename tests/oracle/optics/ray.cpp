#include "tests/oracle/optics/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell::optics {
namespace {

struct Axes {
    glm::dvec3 right, up, forward;
};
Axes axes_of(const Camera& camera) {
    const glm::dvec3 forward = glm::normalize(camera.centre - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, camera.up));
    return {right, glm::cross(right, forward), forward};
}

double half_height(const Camera& camera) { return std::tan(glm::radians(camera.fov_y) / 2.0); }

}  // namespace

std::optional<Crossing> cross_sphere(const Ray& ray, const glm::dvec3& centre, double radius) {
    const double length2 = glm::dot(ray.direction, ray.direction);
    const double middle = glm::dot(centre - ray.origin, ray.direction) / length2;
    const glm::dvec3 off = centre - ray.at(middle);
    const double h2 = radius * radius - glm::dot(off, off);
    if (!(h2 >= 0.0)) return std::nullopt;
    const double half = std::sqrt(h2 / length2);
    return Crossing{middle - half, middle + half};
}

std::optional<Crossing> cross_box(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    Crossing c{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (int axis = 0; axis < 3; ++axis) {
        const double o = ray.origin[axis], d = ray.direction[axis];
        if (d == 0.0) {
            if (o < low[axis] || o > high[axis]) return std::nullopt;
            continue;
        }
        const double a = (low[axis] - o) / d, b = (high[axis] - o) / d;
        c.enter = std::max(c.enter, std::min(a, b));
        c.leave = std::min(c.leave, std::max(a, b));
    }
    if (!(c.enter <= c.leave)) return std::nullopt;
    return c;
}

std::optional<glm::dvec3> room_hit(const Ray& ray, const glm::dvec3& half) {
    if (glm::any(glm::greaterThan(glm::abs(ray.origin), half))) return std::nullopt;
    const auto c = cross_box(ray, -half, half);
    if (!c) return std::nullopt;
    return ray.at(c->leave);
}

Ray camera_ray(const Camera& camera, double x, double y, int width, int height) {
    const Axes axes = axes_of(camera);
    const double scale = 2.0 * half_height(camera) / height;  // of one pixel at distance 1; pixels are square
    const double across = (x - width / 2.0) * scale, upward = (height / 2.0 - y) * scale;
    return {camera.eye, glm::normalize(axes.forward + across * axes.right + upward * axes.up)};
}

}  // namespace snell::optics
