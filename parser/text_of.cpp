#include "parser/text_of.h"

#include <array>
#include <charconv>
#include <cmath>

#include "parser/names.h"
#include "parser/number.h"

namespace snell::text_of {
namespace {

// True when the name needs no quotes.
bool plain(std::string_view name) {
    for (const char c : name) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (!letter && c != '_' && c != '.' && c != '/' && c != '-') return false;
    }
    return !looks_numeric(name) && !name.empty() && name.find("//") == std::string_view::npos;
}

bool has_quote(std::string_view name) {
    for (const std::string_view quote : {"\"", "\xE2\x80\x9C", "\xE2\x80\x9D", "\xE2\x80\x9E"})
        if (name.find(quote) != std::string_view::npos) return true;
    return false;
}

template <class... Numbers>
std::string statement(std::string_view command, Numbers... values) {
    std::string out(command);
    const auto add = [&](auto value) {
        if constexpr (std::is_same_v<decltype(value), int>) {
            out += " " + std::to_string(value);
        } else {
            out += " " + number(value);
        }
    };
    (add(values), ...);
    return out;
}

struct ShapeText {
    const Scene& scene;
    std::string prefix;

    std::string operator()(const Sphere& s) const { return statement(prefix + "Sphere", s.radius, s.slices, s.stacks); }
    std::string operator()(const Torus& t) const {
        return statement(prefix + "Torus", t.outer, t.inner, t.sides, t.rings);
    }
    std::string operator()(const Cone& c) const {
        return statement(prefix + "Cone", c.radius, c.height, c.slices, c.stacks);
    }
    std::string operator()(const Cylinder& c) const {
        return statement(prefix + "Cylinder", c.radius, c.height, c.slices, c.stacks);
    }
    std::string operator()(const Box& b) const { return statement(prefix + "Box", b.dx, b.dy, b.dz); }
    std::string operator()(const Teapot&) const { return prefix + "Teapot"; }
    std::string operator()(const Disk& d) const { return statement("DiskXY", d.z, d.radius, d.slices, d.rings); }
    std::string operator()(const Quad& q) const {
        const std::string_view name = q.plane == Plane::xy ? "QuadXY" : q.plane == Plane::xz ? "QuadXZ" : "QuadYZ";
        return statement(name, q.offset, q.size, q.n1, q.n2);
    }
    std::string operator()(const QuadBox& q) const { return statement("QuadBox", q.n); }
    std::string operator()(const Soccerball& s) const { return statement("Soccerball", s.radius); }
    std::string operator()(const PointCloud& p) const {
        return statement(p.jitter ? "JitterCloud" : "PointCloud", p.nx, p.ny, p.nz);
    }
    std::string operator()(const Xarrow& x) const { return statement("Xarrow", x.n); }
    std::string operator()(const ObjFile& o) const {
        const std::string_view name = o.as == ObjAs::adjacency ? "ObjAdj "
                                      : o.as == ObjAs::patches ? "ObjPatch "
                                                               : "Obj ";
        return prefix + std::string(name) + text_of::name(scene.files[o.file].name);
    }
    std::string operator()(const ShpFile& s) const { return "Shp " + text_of::name(scene.files[s.file].name); }
    std::string operator()(const VertexList& list) const {
        return "glBegin " + std::string(topology_name(scene.vertex_lists[list.list].topology));
    }
};

}  // namespace

std::string number(double value, bool integral) {
    std::array<char, 64> buffer;
    const auto end = integral
                         ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
                         : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    std::string text(buffer.data(), end.ptr);
    if (!integral && text.find_first_of(".e") == std::string::npos) text += '.';
    return text;
}

std::string name(std::string_view name) {
    if (plain(name) || has_quote(name)) return std::string(name);
    return "\"" + std::string(name) + "\"";
}

std::string shape(const Scene& scene, const Shape& shape, bool wire) {
    return std::visit(ShapeText{scene, wire ? "Wire" : ""}, shape);
}

std::string uniform(const UniformValue& u) {
    std::string values;
    for (const double value : u.values) values += (values.empty() ? "" : " ") + number(value, u.integral);
    // A name may end with a backslash only if its value follows at once.
    const bool glued = u.name.ends_with('\\');
    std::string start = u.name + (glued ? "" : " ");
    switch (u.kind) {
        case UniformValue::Kind::scalar:
            return glued ? start + "<" + values + ">" : start + values;
        case UniformValue::Kind::array:
            return start + "[" + values + "]";
        case UniformValue::Kind::range:
        case UniformValue::Kind::boolean:
            return start + "<" + values + ">";
        case UniformValue::Kind::color:
            return start + "{" + values + "}";
    }
    return start;
}

std::string ladder(const Ladder& ladder) {
    std::string out = "Ladder " + ladder.name;
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i)
        out += i == ladder.current ? " <" + ladder.rungs[i] + ">" : " " + ladder.rungs[i];
    return out;
}

std::string texture(const Texture& t) {
    constexpr std::array<std::string_view, texture_target_count> commands{"Texture1D", "Texture2D", "Texture3D",
                                                                          "CubeMap"};
    constexpr std::array<std::size_t, texture_target_count> sizes{1, 2, 3, 1};
    const auto target = static_cast<std::size_t>(t.target);
    if (t.computed == Computed::irradiance) return statement("Irradiance", t.unit, t.from, t.size[0]);
    if (t.computed == Computed::prefilter)
        return t.size[0] > 0 ? statement("Prefilter", t.unit, t.from, t.size[0])
                             : statement("Prefilter", t.unit, t.from);
    std::string out = statement(commands[target], t.unit);
    for (const FileName& file : t.files) out += " " + name(file.name);
    if (t.files.empty())
        for (std::size_t i = 0; i < sizes[target]; ++i) out += " " + std::to_string(t.size[i]);
    return out;
}

std::string filter(const Filter& f) {
    const std::string out = "Filter " + std::string(filter_name(f.mode));
    return f.mode == Filter::Mode::anisotropic ? out + " " + std::to_string(f.anisotropy) : out;
}

std::string projection(const Camera& c) {
    return c.perspective ? statement("Perspective", c.fov) : numbers("Ortho", c.ortho.data(), c.ortho.size());
}

std::string look_at(const Camera& c) { return c.look_at ? numbers("LookAt", c.look_at->front().data(), 9) : "LookAt"; }

std::string numbers(std::string_view command, const double* values, std::size_t count) {
    std::string out(command);
    for (std::size_t i = 0; i < count; ++i) out += " " + number(values[i]);
    return out;
}

std::string_view stage_command(std::size_t stage) {
    constexpr std::array<std::string_view, stage_count> names{"Vertex", "TessControl", "TessEvaluation", "Geometry",
                                                              "Fragment"};
    return names[stage];
}

}  // namespace snell::text_of
