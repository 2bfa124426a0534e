#include <algorithm>
#include <cmath>

#include "parser/text_of.h"
#include "tests/oracle/scene/print.h"

namespace snell {
namespace {

bool near(const Mat4& a, const Mat4& b, double tolerance) {
    double largest = 0;
    for (const std::size_t i : {0, 1, 2, 4, 5, 6, 8, 9, 10}) largest = std::max(largest, std::abs(a[i]));
    for (std::size_t i = 0; i < 12; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance * largest)) return false;
    for (std::size_t i = 12; i < 16; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance * std::abs(a[i]))) return false;
    return true;
}

bool same_list(const VertexListData& a, const VertexListData& b) {
    const auto same_vertex = [](const ListVertex& v, const ListVertex& w) {
        return v.position == w.position && v.normal == w.normal && v.texcoord == w.texcoord && v.color == w.color;
    };
    return a.topology == b.topology && a.patch_vertices == b.patch_vertices && a.has_color == b.has_color &&
           std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), same_vertex);
}

std::string program_text(const Program& p) {
    std::string text = p.name;
    for (const auto& stage : p.stages) text += "|" + (stage ? stage->name : std::string());
    text += "|" + p.geometry_input + "|" + p.geometry_output;
    text += "|" + std::to_string(p.ladders);
    for (const UniformValue& u : p.uniforms)
        text += "|" + std::to_string(static_cast<int>(u.kind)) + text_of::uniform(u);
    return text;
}

std::string draw_difference(const Scene& a, const Draw& x, const Scene& b, const Draw& y, double tolerance) {
    if (x.wire != y.wire || text_of::shape(a, x.shape, x.wire) != text_of::shape(b, y.shape, y.wire)) return "shape";
    const auto* list = std::get_if<VertexList>(&x.shape);
    if (list && !same_list(a.vertex_lists[list->list], b.vertex_lists[std::get<VertexList>(y.shape).list]))
        return "vertices";
    if (!near(a.matrices[x.matrix], b.matrices[y.matrix], tolerance)) return "matrix";
    const Camera &c = a.cameras[x.camera], &d = b.cameras[y.camera];
    if (text_of::projection(c) != text_of::projection(d) || c.look_at != d.look_at) return "camera";
    if (a.rasters[x.raster] != b.rasters[y.raster]) return "raster state";
    if (a.bindings[x.bindings].entries != b.bindings[y.bindings].entries) return "bindings";
    if (a.colors[x.color] != b.colors[y.color]) return "color";
    return x.program != y.program ? "program" : "";
}

std::string pass_difference(const Pass& p, const Pass& q) {
    const auto same_item = [](const Item& a, const Item& b) { return a.kind == b.kind && a.index == b.index; };
    const bool same = p.kind == q.kind && p.units == q.units && p.textures == q.textures && p.center == q.center &&
                      p.faces_per_frame == q.faces_per_frame && p.background == q.background &&
                      std::equal(p.items.begin(), p.items.end(), q.items.begin(), q.items.end(), same_item);
    return same ? "" : "pass";
}

// The first pair of elements that differ, or the lengths.
template <class List, class Compare>
std::string lists(const char* what, const List& a, const List& b, Compare compare) {
    if (a.size() != b.size()) return std::string("number of ") + what;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::string d = compare(a[i], b[i]);
        if (!d.empty()) return std::string(what) + " " + std::to_string(i) + ": " + d;
    }
    return {};
}

}  // namespace

std::string difference(const Scene& a, const Scene& b, double tolerance) {
    if (a.window_size != b.window_size || a.background != b.background || a.output != b.output ||
        a.timer_period != b.timer_period || a.noise2d != b.noise2d || a.noise3d != b.noise3d || a.gstap != b.gstap ||
        a.verbose != b.verbose)
        return "settings";
    const auto unequal = [](const auto& text) {
        return [text](const auto& x, const auto& y) { return std::string(text(x) == text(y) ? "" : "text"); };
    };
    std::string d = lists("messages", a.messages, b.messages, unequal([](const Message& m) { return m.text; }));
    if (d.empty()) d = lists("ladders", a.ladders, b.ladders, unequal(text_of::ladder));
    if (d.empty()) d = lists("programs", a.programs, b.programs, unequal(program_text));
    if (d.empty())
        d = lists("textures", a.textures, b.textures,
                  unequal([](const Texture& t) { return text_of::filter(t.filter) + "|" + text_of::texture(t); }));
    if (d.empty()) d = lists("passes", a.passes, b.passes, pass_difference);
    if (d.empty())
        d = lists("draws", a.draws, b.draws,
                  [&](const Draw& x, const Draw& y) { return draw_difference(a, x, b, y, tolerance); });
    return d;
}

}  // namespace snell
