#include "src/ui/scene_mouse.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "src/plan/lens.h"
#include "src/plan/objects.h"
#include "src/plan/plan.h"
#include "src/ui/kit/numbers.h"

namespace snell::ui {

namespace {

constexpr double degrees_per_point = .5;
constexpr double scale_per_step = 1.1;     // per step of the wheel
constexpr double scale_per_point = 1.006;  // per point of a drag
constexpr double points_per_step = 20;     // per step of the wheel, towards the viewer
constexpr double smallest = 1e-3, largest = 1e3;
constexpr float still = 3;  // in points: a press that moves less is a click

// The effect of a gesture, in points of the window.
struct Gesture {
    glm::dvec3 move{0};  // right, up, toward the viewer
    glm::dvec2 turn{0};  // right, down
    double scale = 1;
};

// With `picks`, a press that does not move will be a click, and does not turn anything.
Gesture gesture(const Rect& area, bool picks) {
    const ImGuiIO& io = ImGui::GetIO();
    Gesture made;
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

glm::dmat4 matrix(const Mat4& m) {
    glm::dmat4 result;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) result[column][row] = m[static_cast<std::size_t>(column * 4 + row)];
    return result;
}

// Converts points to the units of the transformation that is held, so that what is dragged stays under the mouse.
glm::dvec3 moved(const glm::dvec3& points, const Scene& scene, const View& view, const HoldMemory& hold,
                 double shorter) {
    if (hold.held == Held::texture) return glm::dvec3(-points.x, -points.y, points.z) / shorter;
    const bool object = hold.held == Held::object && hold.object < scene.draws.size();
    const Draw* draw = object ? &scene.draws[hold.object] : nullptr;
    const Camera camera =
        draw && draw->camera < scene.cameras.size() ? scene.cameras[draw->camera] : window_camera(scene);
    const glm::dmat4 seen = eye_from_world(camera, view);
    const Lens lens = lens_of(camera, view.projection, seen);
    const glm::dvec3 origin(seen[3]);
    const Transformation t = held(view, hold);
    if (!object) {
        const glm::dvec3 at = hold.held == Held::scene ? origin + glm::dvec3(t.x, t.y, t.z) : origin;
        return points * units_per_step(lens, at, shorter);
    }
    const glm::dmat4 model =
        draw->matrix < scene.matrices.size() ? matrix(scene.matrices[draw->matrix]) : glm::dmat4(1);
    const glm::dvec3 in_eye(seen * placed(t, camera, model)[3]);
    const glm::dmat4 turned = about_origin(view.scene, camera, seen);
    const glm::dvec3 at(turned * glm::dvec4(in_eye, 1));
    const glm::dmat3 eye(seen * glm::inverse(view_matrix(camera)));
    const glm::dvec3 way = glm::inverse(glm::dmat3(turned) * eye) * (points * units_per_step(lens, at, shorter));
    const bool finite = std::isfinite(way.x) && std::isfinite(way.y) && std::isfinite(way.z);
    return finite ? way : glm::dvec3(0);
}

// True if the tilt has put the scene upside down: the vertical then points down on the screen.
bool upside_down(const Transformation& t, const Scene& scene) {
    const Camera camera = window_camera(scene);
    const glm::dvec3 up = vertical_of(camera, view_matrix(camera));
    const double tilt = glm::radians(t.rotate_x);
    return up.y * std::cos(tilt) - up.z * std::sin(tilt) < -1e-9;
}

void apply(const Gesture& made, const Facts& facts, const Rect& area, View& view, const HoldMemory& hold) {
    const Transformation before = held(view, hold);
    Transformation t = before;
    if (made.move != glm::dvec3(0)) {
        const double shorter = std::max(1.0F, std::min(area.width, area.height));
        const glm::dvec3 way = moved(made.move, *facts.scene, view, hold, shorter);
        const double step = glm::length(way) / glm::length(made.move);
        for (const auto& [value, part] : {std::pair(&t.x, way.x), {&t.y, way.y}, {&t.z, way.z}})
            if (part != 0) *value = tidy_step(*value + part, step);
    }
    const bool texture = hold.held == Held::texture;
    const auto turn = [](double& angle, double points) {
        if (points != 0) angle = std::remainder(angle + points * degrees_per_point, 360);
    };
    // What is in front follows the mouse.
    if (texture) {
        turn(t.rotate_z, made.turn.x);
    } else {
        turn(t.rotate_y, hold.flipped ? -made.turn.x : made.turn.x);
        turn(t.rotate_x, made.turn.y);
    }
    // Larger coordinates make the texture's picture smaller.
    if (made.scale != 1) t.scale = std::clamp(t.scale * (texture ? 1 / made.scale : made.scale), smallest, largest);
    if (!(t == before)) set_held(view, hold, t);
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
        apply(gesture(area, hold.picking), facts, area, view, hold);
        if (hold.picking) requests.pick = clicked(area);
    }
    if (facts.mouse && area.contains(io.MousePos.x, io.MousePos.y)) {
        view.mouse_x = (io.MousePos.x - area.x) * io.DisplayFramebufferScale.x;
        view.mouse_y = (area.y + area.height - io.MousePos.y) * io.DisplayFramebufferScale.y;
    }
}

}  // namespace snell::ui
