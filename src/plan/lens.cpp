#include "src/plan/lens.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace snell {

namespace {

double half_angle(const Camera& camera) {
    const bool sound = camera.fov > 0 && camera.fov < 180;
    return glm::radians((sound ? camera.fov : Camera{}.fov) / 2);
}

}  // namespace

Lens lens_of(const Camera& camera, Projection chosen, const glm::dmat4& view) {
    Lens lens{camera, glm::dmat4(1)};
    const bool perspective = chosen == Projection::perspective;
    if (chosen == Projection::scene || camera.perspective == perspective) return lens;
    lens.camera.perspective = perspective;
    const double slope = std::tan(half_angle(camera)), origin = view[3].z;
    if (perspective) {
        const auto& [left, right, bottom, top] = camera.ortho;
        const double distance = std::max(std::abs(top - bottom), std::abs(right - left)) / 2 / slope;
        const glm::dvec3 shift(-(left + right) / 2, -(bottom + top) / 2, -distance - origin);
        if (distance > 0 && std::isfinite(shift.x) && std::isfinite(shift.y) && std::isfinite(shift.z))
            lens.shift = glm::translate(glm::dmat4(1), shift);
    } else if (const double half = -origin * slope; half > 1e-6 && std::isfinite(half)) {
        lens.camera.ortho = {-half, half, -half, half};
    }
    return lens;
}

Camera window_camera(const Scene& scene) {
    for (std::size_t pass = scene.passes.size(); pass-- > 0;) {
        if (scene.passes[pass].kind != Pass::Kind::window) continue;
        const auto& items = scene.passes[pass].items;
        for (std::size_t i = items.size(); i-- > 0;)
            if (items[i].kind == Item::Kind::draw) return scene.cameras[scene.draws[items[i].index].camera];
    }
    return {};
}

double units_per_step(const Lens& lens, const glm::dvec3& point, double shorter) {
    shorter = std::max(1.0, shorter);
    const Camera& camera = lens.camera;
    const double box =
        std::min(std::abs(camera.ortho[3] - camera.ortho[2]), std::abs(camera.ortho[1] - camera.ortho[0]));
    if (!camera.perspective) return (std::isfinite(box) && box > 0 ? box : 6) / shorter;
    const double distance = -(lens.shift * glm::dvec4(point, 1)).z;
    return 2 * (distance > 1e-3 && std::isfinite(distance) ? distance : 1) * std::tan(half_angle(camera)) / shorter;
}

std::array<double, 4> background_of(double brightness) {
    const double v = std::clamp(brightness, 0.0, 1.0);
    return {.5455 * v, .818 * v, v, 1};
}

}  // namespace snell
