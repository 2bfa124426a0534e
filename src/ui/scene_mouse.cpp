#include "src/ui/scene_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "src/plan/plan.h"
#include "src/platform/window.h"

namespace snell::ui {

namespace {

constexpr double degrees_per_point = .5;
constexpr double scale_per_step = 1.1;     // of the wheel
constexpr double scale_per_point = 1.006;  // of a drag
constexpr double smallest = 1e-3, largest = 1e3;

// How far the world's origin moves on the screen: in its units, for one point of the window.
double units_per_point(const Scene& scene, const Rect& area) {
    const double shorter = std::max(1.0F, std::min(area.width, area.height));
    if (scene.cameras.empty()) return 2 / shorter;
    const Camera& camera = scene.cameras.front();
    if (!camera.perspective) return std::abs(camera.ortho[3] - camera.ortho[2]) / shorter;
    const double distance = glm::length(glm::dvec3(view_matrix(camera)[3]));
    const double half = std::tan(glm::radians(std::clamp(camera.fov, 1.0, 170.0) / 2));
    return 2 * (distance > 0 ? distance : 1) * half / shorter;
}

void drag(const Facts& facts, const Rect& area, Transformation& held) {
    const ImGuiIO& io = ImGui::GetIO();
    const double dx = io.MouseDelta.x, dy = io.MouseDelta.y;
    if ((dx == 0 && dy == 0) || !std::isfinite(dx) || !std::isfinite(dy)) return;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyCtrl)) {
        held.scale = std::clamp(held.scale * std::pow(scale_per_point, dx - dy), smallest, largest);
    } else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || (left && io.KeyShift)) {
        const double unit = units_per_point(*facts.scene, area);
        held.x += dx * unit;
        held.y -= dy * unit;
    } else if (left) {
        held.rotate_y = std::remainder(held.rotate_y + dx * degrees_per_point, 360);
        held.rotate_x = std::remainder(held.rotate_x + dy * degrees_per_point, 360);
    }
}

}  // namespace

void hold_scene(const Facts& facts, const Rect& area, View& view) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.WantCaptureMouse) {
        drag(facts, area, view.scene);
        if (io.MouseWheel != 0 && area.contains(io.MousePos.x, io.MousePos.y))
            view.scene.scale =
                std::clamp(view.scene.scale * std::pow(scale_per_step, io.MouseWheel), smallest, largest);
    }
    if (facts.mouse && area.contains(io.MousePos.x, io.MousePos.y)) {
        view.mouse_x = (io.MousePos.x - area.x) * io.DisplayFramebufferScale.x;
        view.mouse_y = (area.y + area.height - io.MousePos.y) * io.DisplayFramebufferScale.y;
    }
    if (!io.WantTextInput && (ImGui::IsKeyPressed(static_cast<int>(Key::r), false) ||
                              ImGui::IsKeyPressed(static_cast<int>(Key::home), false)))
        view.scene = {};
}

}  // namespace snell::ui
