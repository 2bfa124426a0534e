#include "src/plan/view.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/plan.h"

namespace snell {
namespace {

struct SinCos {
    double sin, cos;
};

// Takes degrees and reduces them before the conversion to radians, so that 1e9 degrees lose no accuracy and multiples
// of 90 are exact.
SinCos sin_cos(double degrees) {
    if (!std::isfinite(degrees)) return {0, 1};
    const double reduced = std::remainder(degrees, 360.);
    const double quarter = std::nearbyint(reduced / 90.);
    const double rest = (reduced - 90. * quarter) * (std::numbers::pi / 180.);
    const double s = std::sin(rest), c = std::cos(rest);
    const std::array<SinCos, 4> turned{{{s, c}, {c, -s}, {-s, -c}, {-c, s}}};
    return turned[static_cast<std::size_t>(quarter + 4) % 4];
}

double finite_or(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

double half_angle(const Camera& camera) {
    const bool sound = camera.fov > 0 && camera.fov < 180;
    return glm::radians((sound ? camera.fov : Camera{}.fov) / 2);
}

// Returns the member of View, or null for the transformation of an object.
Transformation View::*part(Held held) {
    constexpr std::array<Transformation View::*, 4> members{&View::scene, &View::eye, nullptr, &View::texture};
    return members[static_cast<std::size_t>(held)];
}

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

glm::dmat4 Transformation::matrix(const glm::dvec3& vertical) const {
    const auto [sx, cx] = sin_cos(rotate_x);
    const auto [sy, cy] = sin_cos(rotate_y);
    const auto [sz, cz] = sin_cos(rotate_z);
    const glm::dmat3 tilt(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    const glm::dmat3 roll(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
    const glm::dvec3& v = vertical;
    // Rodrigues' formula.
    const glm::dmat3 turn = cy * glm::dmat3(1) + (1 - cy) * glm::outerProduct(v, v) +
                            sy * glm::dmat3(0, v.z, -v.y, -v.z, 0, v.x, v.y, -v.x, 0);
    glm::dmat4 result(finite_or(scale, 1) * tilt * turn * roll);
    result[3] = {finite_or(x, 0), finite_or(y, 0), finite_or(z, 0), 1};
    return result;
}

glm::dvec3 vertical_of(const Camera& camera, const glm::dmat4& view) {
    const glm::dvec3 screen_up(0, 1, 0);
    const Vec3 up = camera.look_at ? (*camera.look_at)[2] : Vec3{0, 1, 0};
    const double size = std::max({std::abs(up[0]), std::abs(up[1]), std::abs(up[2])});
    if (!(size > 0) || !std::isfinite(size)) return screen_up;
    const glm::dvec3 seen = glm::dmat3(view) * (glm::dvec3(up[0], up[1], up[2]) / size);
    const double length = glm::length(seen);
    return length > 0 && std::isfinite(length) ? seen / length : screen_up;
}

glm::dmat4 eye_from_world(const Camera& camera, const View& view) {
    const glm::dmat4 own = view_matrix(camera);
    return view.eye == Transformation{} ? own : view.eye.matrix(vertical_of(camera, own)) * own;
}

glm::dmat4 about_origin(const Transformation& scene, const Camera& camera, const glm::dmat4& view) {
    if (scene == Transformation{}) return glm::dmat4(1);
    const glm::dvec3 pivot(view[3]);
    return glm::translate(glm::dmat4(1), pivot) * scene.matrix(vertical_of(camera, view)) *
           glm::translate(glm::dmat4(1), -pivot);
}

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

void hold_object(HoldMemory& hold, Index object) {
    hold.object = object;
    if (object != none)
        hold.held = Held::object;
    else if (hold.held == Held::object)
        hold.held = Held::scene;
}

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
    const double half = (sound ? camera.fov : Camera{}.fov) / 2 * (std::numbers::pi / 180);
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

glm::dmat4 placed(const Transformation& object, const Camera& camera, const glm::dmat4& model) {
    if (object == Transformation{}) return model;
    const glm::dmat4 view = view_matrix(camera);
    const glm::dvec3 origin(view * model[3]);
    const glm::dmat4 in_eye = glm::translate(glm::dmat4(1), origin) * object.matrix(vertical_of(camera, view)) *
                              glm::translate(glm::dmat4(1), -origin);
    return glm::inverse(view) * in_eye * view * model;
}

std::vector<std::string> object_names(const Scene& scene) {
    std::map<std::string, int> before;
    std::vector<std::string> names;
    for (const Draw& draw : scene.draws) {
        std::string name = shape_key(scene, draw.shape, draw.wire);
        name += '#' + std::to_string(before[name]++);
        names.push_back(std::move(name));
    }
    return names;
}

bool flat_picture(const Scene& scene) {
    const Draw* first = nullptr;
    const auto matrix = [&](const Draw& draw) { return draw.matrix == none ? Mat4{} : scene.matrices[draw.matrix]; };
    for (const Pass& pass : scene.passes) {
        if (pass.kind != Pass::Kind::window) continue;
        for (const Item& item : pass.items) {
            if (item.kind != Item::Kind::draw) continue;
            const Draw& draw = scene.draws[item.index];
            const Quad* quad = std::get_if<Quad>(&draw.shape);
            if (!quad || quad->n1 != 1 || quad->n2 != 1) return false;
            if (!first) first = &draw;
            const Quad& other = std::get<Quad>(first->shape);
            if (quad->plane != other.plane || quad->offset != other.offset || draw.camera != first->camera)
                return false;
            if (draw.matrix != first->matrix && matrix(draw) != matrix(*first)) return false;
        }
    }
    return first != nullptr;
}

Index carried(const std::vector<std::string>& from, const std::vector<std::string>& to, Index object) {
    if (object >= from.size()) return none;
    if (from.size() == to.size()) return object;
    const auto same = ranges::find(to, from[object]);
    return same == to.end() ? none : static_cast<Index>(same - to.begin());
}

void carry_objects(const std::vector<std::string>& from, const std::vector<std::string>& to, View& view) {
    for (const auto& [draw, transformation] : std::exchange(view.objects, {}))
        if (const Index found = carried(from, to, draw); found != none) view.objects[found] = transformation;
}

}  // namespace snell
