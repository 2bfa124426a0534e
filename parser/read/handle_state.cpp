// View, transformations, and the state of the draws that follow.
#include <algorithm>
#include <cmath>

#include "parser/commands/handlers.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"
#include "parser/text/ranges.h"
#include "parser/vectors.h"

namespace snell::handle {
namespace {

constexpr double pi = 3.14159265358979323846;

template <class Change>
void change_raster(Builder& b, Change change) {
    RasterState raster = b.raster();
    change(raster);
    b.set_raster(raster);
}

bool is_on(const Arguments& a) { return a.integer(0) == 0; }

// 255 128 0 rather than a bright light.
bool of_bytes(const Vec4& color) {
    const auto byte = [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); };
    return ranges::all_of(color, byte) && std::max({color[0], color[1], color[2]}) > 16;
}

// r g b a as four numbers, or as one bracket of three or four.
Vec4 numbers_of_color(const Arguments& a) {
    if (a.alternative() == 0) return {a.number(0), a.number(1), a.number(2), a.number(3)};
    const auto v = a.numbers(0);
    return {v[0], v[1], v[2], v.size() > 3 ? v[3] : 1};
}

Vec4 color_of(Builder& b, const Arguments& a) {
    const Vec4 color = numbers_of_color(a);
    if (of_bytes(color))
        b.report().warning("color-of-bytes", a.span(), "a colour has numbers from 0 to 1, not to 255",
                           "divide each by 255");
    return color;
}

void apply(Builder& b, const Arguments& a, const Mat4& matrix) {
    if (!b.transform(matrix))
        b.report().error("matrix-overflow", a.span(), "the transformation leaves the range of numbers: it is ignored");
}

struct Angle {
    double sine, cosine;
};

// The angle is reduced in degrees, so that large angles keep their digits and quarter turns are exact.
Angle angle_of(double degrees) {
    const double reduced = std::fmod(degrees, 360);
    const double quarter = reduced / 90;
    if (quarter == std::floor(quarter)) {
        constexpr std::array<Angle, 4> quarters{{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
        return quarters[(static_cast<std::size_t>(quarter + 4)) % 4];
    }
    const double radians = reduced * (pi / 180);
    return {std::sin(radians), std::cos(radians)};
}

// This is glRotate for a unit axis, as the OpenGL specification defines it under "Matrices".
Mat4 rotation(const Angle& angle, const Vec3& u) {
    const double c = angle.cosine, s = angle.sine, t = 1 - c;
    return {u[0] * u[0] * t + c,
            u[1] * u[0] * t + u[2] * s,
            u[0] * u[2] * t - u[1] * s,
            0,
            u[0] * u[1] * t - u[2] * s,
            u[1] * u[1] * t + c,
            u[1] * u[2] * t + u[0] * s,
            0,
            u[0] * u[2] * t + u[1] * s,
            u[1] * u[2] * t - u[0] * s,
            u[2] * u[2] * t + c,
            0,
            0,
            0,
            0,
            1};
}

// The vector is divided by its largest component, so that neither tiny nor huge vectors lose their direction.
Vec3 scaled_to_one(const Vec3& v) {
    const double m = largest(v);
    return m > 0 ? divided(v, m) : v;
}

}  // namespace

void window_size(Builder& b, const Arguments& a) {
    const int wx = a.integer(0), wy = a.integer(1);
    const auto most = static_cast<int>(b.limits().output_side);
    if (wx < 1 || wy < 1 || wx > most || wy > most) {
        b.report().error("size-out-of-range", a.span(), "a window has 1 to " + std::to_string(most) + " pixels a side",
                         "the size is left as it was" +
                             (std::max(wx, wy) > most ? "; " + limit_help(b.limits(), &Limits::output_side) : ""));
        return;
    }
    b.scene().window_size = {wx, wy};
}

void ortho(Builder& b, const Arguments& a) {
    Camera camera = b.camera();
    camera.perspective = false;
    camera.ortho = {a.number(0), a.number(1), a.number(2), a.number(3)};
    const auto& o = camera.ortho;
    const bool all_zero = o == std::array<double, 4>{};
    if (all_zero) {
        b.report().warning("empty-ortho", a.span(), "Ortho 0 0 0 0 shows nothing: -3 3 -3 3 is used");
    } else if (o[0] == o[1] || o[2] == o[3]) {
        b.report().error("empty-ortho", a.span(),
                         o[0] == o[1] ? "left and right are equal" : "bottom and top are equal", "-3 3 -3 3 is used");
    }
    if (o[0] == o[1] || o[2] == o[3]) camera.ortho = Camera{}.ortho;
    b.set_camera(camera);
}

void perspective(Builder& b, const Arguments& a) {
    Camera camera = b.camera();
    camera.perspective = true;
    camera.fov = a.number(0);
    if (camera.fov <= 0 || camera.fov >= 180) {
        b.report().error("field-of-view-out-of-range", a.span(0), "a field of view lies between 0 and 180 degrees",
                         "50 is used");
        camera.fov = Camera{}.fov;
    }
    b.set_camera(camera);
}

void look_at(Builder& b, const Arguments& a) {
    Camera camera = b.camera();
    if (a.alternative() == 0) {
        camera.look_at.reset();
        b.set_camera(camera);
        return;
    }
    const Vec3 eye{a.number(0), a.number(1), a.number(2)};
    const Vec3 centre{a.number(3), a.number(4), a.number(5)};
    const Vec3 up{a.number(6), a.number(7), a.number(8)};
    camera.look_at = {eye, centre, up};
    b.set_camera(camera);
    if (a.mended()) return;  // the one mistake is said
    const Vec3 forward = scaled_to_one(difference(centre, eye));
    const Vec3 side = cross(forward, scaled_to_one(up));
    if (largest(forward) == 0) {
        b.report().warning("look-at-itself", a.span(), "the eye looks at itself: it has no direction",
                           "the eye, the first three numbers, and the point looked at, the next three, differ");
    } else if (largest(side) < 1e-12) {
        b.report().warning("look-at-up", a.span(),
                           "the up vector, the last three numbers, does not say which side is up",
                           "it must not be zero or point where the eye looks; another one is used");
    }
}

void background(Builder& b, const Arguments& a) { b.set_background(color_of(b, a)); }

void output(Builder& b, const Arguments& a) { b.scene().output = static_cast<Encoding>(a.integer(0)); }

void clear(Builder& b, const Arguments& a) { b.clear(a.span()); }

void translate(Builder& b, const Arguments& a) {
    apply(b, a, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, a.number(0), a.number(1), a.number(2), 1});
}

void rotate(Builder& b, const Arguments& a) {
    const Vec3 axis = scaled_to_one({a.number(1), a.number(2), a.number(3)});
    if (length(axis) == 0 && a.mended()) return;  // which is said
    if (length(axis) == 0) {
        b.report().error("zero-axis", a.span(), "a rotation needs an axis that is not 0 0 0: it is ignored",
                         "usage: Rotate angle x y z");
        return;
    }
    apply(b, a, rotation(angle_of(a.number(0)), divided(axis, length(axis))));
}

void scale(Builder& b, const Arguments& a) {
    if (a.mended()) return;  // by 0, which would leave nothing to be seen
    const bool uniform = a.alternative() == 0;
    const double x = a.number(0), y = uniform ? x : a.number(1), z = uniform ? x : a.number(2);
    apply(b, a, {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1});
}

void push_matrix(Builder& b, const Arguments& a) { b.push_matrix(a.span()); }

void pop_matrix(Builder& b, const Arguments& a) { b.pop_matrix(a.span()); }

// As in OpenGL, the colour of the draws that follow and of the vertices that follow is the same state.
void color(Builder& b, const Arguments& a) {
    b.set_color(color_of(b, a));
    if (VertexListData* list = b.open_list()) {
        if (!list->has_color)
            for (ListVertex& v : list->vertices) v.color = b.list_color();
        list->has_color = true;
    }
}

void line_width(Builder& b, const Arguments& a) {
    if (a.number(0) > 0) return change_raster(b, [&](RasterState& r) { r.line_width = a.number(0); });
    b.report().error("size-out-of-range", a.span(0), "a line is wider than 0: the width is left as it was");
}

void point_size(Builder& b, const Arguments& a) {
    if (a.number(0) > 0) return change_raster(b, [&](RasterState& r) { r.point_size = a.number(0); });
    b.report().error("size-out-of-range", a.span(0), "a point is larger than 0: the size is left as it was");
}

void point_size_mode(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) { r.point_size_mode = a.number(0) != 0; });
}

void flat(Builder& b, const Arguments&) {
    change_raster(b, [](RasterState& r) { r.flat = true; });
}

void smooth(Builder& b, const Arguments&) {
    change_raster(b, [](RasterState& r) { r.flat = false; });
}

void clamp(Builder& b, const Arguments&) {
    change_raster(b, [](RasterState& r) { r.clamp = true; });
}

void blend(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) {
        r.src = RasterState{}.src;
        r.dst = RasterState{}.dst;
        r.blend = a.alternative() == 1 || is_on(a);
        if (a.alternative() == 1) {
            r.src = static_cast<BlendFactor>(a.integer(0));
            r.dst = static_cast<BlendFactor>(a.integer(1));
        }
    });
}

void cull_face(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) { r.cull = static_cast<CullFace>(a.integer(0)); });
}

void depth_test(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) { r.depth_test = is_on(a); });
}

void depth_write(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) { r.depth_write = is_on(a); });
}

void wireframe(Builder& b, const Arguments& a) {
    change_raster(b, [&](RasterState& r) { r.wireframe = is_on(a); });
}

}  // namespace snell::handle
