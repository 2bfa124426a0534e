#include "src/plan/gesture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "src/plan/objects.h"
#include "src/plan/plan.h"
#include "src/plan/view.h"

namespace snell {

void hold_object(HoldMemory& hold, Index object) {
    hold.object = object;
    if (object != none)
        hold.held = Held::object;
    else if (hold.held == Held::object)
        hold.held = Held::scene;
}

namespace {

// Returns the member of View, or null for the transformation of an object.
Transformation View::*part(Held held) {
    switch (held) {
        case Held::scene:
            return &View::scene;
        case Held::eye:
            return &View::eye;
        case Held::texture:
            return &View::texture;
        case Held::object:
            break;
    }
    return nullptr;
}

}  // namespace

Transformation held(const View& view, const HoldMemory& hold) {
    if (const auto member = part(hold.held)) return view.*member;
    const auto object = view.objects.find(hold.object);
    return object == view.objects.end() ? Transformation{} : object->second;
}

void set_held(View& view, const HoldMemory& hold, const Transformation& transformation) {
    if (const auto member = part(hold.held))
        view.*member = transformation;
    else if (hold.object != none && transformation == Transformation{})
        view.objects.erase(hold.object);
    else if (hold.object != none)
        view.objects[hold.object] = transformation;
}

void reset_view(View& view) {
    View fresh;
    fresh.axes = view.axes;
    fresh.mouse_x = view.mouse_x;
    fresh.mouse_y = view.mouse_y;
    view = std::move(fresh);
}

namespace {

constexpr double degrees_per_point = .5;
constexpr double smallest = 1e-3, largest = 1e3;

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

}  // namespace

bool upside_down(const Transformation& t, const Scene& scene) {
    const Camera camera = window_camera(scene);
    const glm::dvec3 up = vertical_of(camera, view_matrix(camera));
    const double tilt = glm::radians(t.rotate_x);
    return up.y * std::cos(tilt) - up.z * std::sin(tilt) < -1e-9;
}

void apply(const ViewGesture& made, const Scene& scene, double shorter, View& view, const HoldMemory& hold) {
    const Transformation before = held(view, hold);
    Transformation t = before;
    if (made.move != glm::dvec3(0)) {
        const glm::dvec3 way = moved(made.move, scene, view, hold, shorter);
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

double tidy_step(double value, double step) {
    const double scale = std::pow(10, -std::floor(std::log10(step / 100)));
    const double result = std::round(value * scale) / scale;
    return std::isfinite(result) ? result : value;
}

}  // namespace snell
