#include "src/ui/scene_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "src/plan/hand/gesture.h"

namespace snell::ui {

namespace {

constexpr double scale_per_step = 1.1;     // per step of the wheel
constexpr double scale_per_point = 1.006;  // per point of a drag
constexpr double points_per_step = 20;     // per step of the wheel, towards the viewer
constexpr float still = 3;                 // in points: a press that moves less is a click

// With `picks`, a press that does not move will be a click, and does not turn anything.
ViewGesture gesture(const Rect& area, bool picks) {
    const ImGuiIO& io = ImGui::GetIO();
    ViewGesture made;
    if (area.contains(io.MousePos.x, io.MousePos.y)) {
        // Some systems swap the wheel's axes while Shift is down.
        if (io.KeyShift)
            made.move.z = points_per_step * (io.MouseWheel + io.MouseWheelH);
        else
            made.scale = std::pow(scale_per_step, io.MouseWheel);
    }
    const double dx = io.MouseDelta.x, dy = io.MouseDelta.y;
    if ((dx == 0 && dy == 0) || !std::isfinite(dx) || !std::isfinite(dy)) return made;
    const bool left = ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (left && io.KeyCtrl && io.KeyShift)
        made.move.z += dy;
    else if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) || (left && io.KeyCtrl))
        made.scale *= std::pow(scale_per_point, dx - dy);
    else if (ImGui::IsMouseDown(ImGuiMouseButton_Right) || (left && io.KeyShift))
        made.move += glm::dvec3(dx, -dy, 0);
    else if (left && !(picks && io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <= still * still))
        made.turn = {dx, dy};
    return made;
}

std::optional<Point> clicked(const Rect& area) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left) || io.KeyShift || io.KeyCtrl ||
        io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] > still * still ||
        !area.contains(io.MousePos.x, io.MousePos.y))
        return std::nullopt;
    return Point{io.MousePos.x - area.x, io.MousePos.y - area.y};
}

}  // namespace

void hold_scene(const Facts& facts, const Rect& area, View& view, HoldMemory& hold, Requests& requests) {
    if (!facts.scene) return;
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.WantCaptureMouse) {
        // It stays so until the button is up: the same position of the mouse gives the same view.
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) hold.flipped = upside_down(held(view, hold), *facts.scene);
        apply(gesture(area, hold.picking), *facts.scene, std::max(1.0F, std::min(area.width, area.height)), view, hold);
        if (hold.picking) requests.pick = clicked(area);
    }
    if (facts.mouse && area.contains(io.MousePos.x, io.MousePos.y)) {
        view.mouse_x = (io.MousePos.x - area.x) * io.DisplayFramebufferScale.x;
        view.mouse_y = (area.y + area.height - io.MousePos.y) * io.DisplayFramebufferScale.y;
    }
}

}  // namespace snell::ui
