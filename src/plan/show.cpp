#include "src/plan/show.h"

#include <algorithm>
#include <cmath>

namespace snell {

namespace {

// The corners' box.
struct Extent {
    glm::dvec3 min{HUGE_VAL}, max{-HUGE_VAL};
    glm::dvec3 middle() const { return (min + max) * .5; }
    double radius() const { return glm::length(max - min) / 2; }
};

Extent extent_of(std::span<const DepthBox> boxes) {
    Extent extent;
    for (const DepthBox& box : boxes)
        for (const glm::dvec3& p : box.corners()) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
            extent.min = glm::min(extent.min, p);
            extent.max = glm::max(extent.max, p);
        }
    return extent;
}

// To two digits, away from zero: what a person would write.
double rounded(double value) {
    if (value == 0 || !std::isfinite(value)) return 0;
    const double step = std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    const double whole = std::ceil(std::abs(value) / step - 1e-9) * step;
    // 0.30000000000000004 is .3
    const double clean = std::round(whole * 1e9) / 1e9;
    return std::copysign(clean > 0 ? clean : whole, value);
}

}  // namespace

std::vector<View> views_to_try(std::span<const DepthBox> boxes, const Camera& camera, const View& current) {
    const Extent extent = extent_of(boxes);
    const double radius = std::max(extent.radius(), 1e-6);
    if (!std::isfinite(radius)) return {};
    const glm::dvec3 middle = extent.middle();
    const bool sound = camera.fov > 0 && camera.fov < 180;
    const double half = (sound ? camera.fov : Camera{}.fov) / 2 * (3.14159265358979323846 / 180);
    // So far that all of it is in the picture; beyond the near plane, at .1.
    const double distance =
        camera.perspective ? std::max(radius / std::sin(std::min(half, 1.4)), radius + .2) : radius + 1;
    const double away = -distance - middle.z;

    std::vector<View> views;
    View straight = current;
    straight.scene.z = rounded(current.scene.z + away);
    views.push_back(straight);
    View centred = straight;
    centred.scene.x = rounded(current.scene.x - middle.x);
    centred.scene.y = rounded(current.scene.y - middle.y);
    views.push_back(centred);
    // Larger than what lies before the far plane, at 1000, or than the box of an orthographic camera.
    const auto& [left, right, bottom, top] = camera.ortho;
    const double room = camera.perspective ? 900 : std::min(std::abs(right - left), std::abs(top - bottom)) / 2;
    const double size = camera.perspective ? distance + radius : radius;
    if (size > room && room > 0) {
        View smaller = current;
        smaller.scene.scale = current.scene.scale * rounded(room / size);
        smaller.scene.z = rounded(current.scene.z - std::min(distance, 400.));
        views.push_back(smaller);
    }
    return views;
}

}  // namespace snell
