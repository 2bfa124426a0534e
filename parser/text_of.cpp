#include "parser/text_of.h"

#include <array>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell::text_of {
namespace {

// Returns true if the name needs no quotes.
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

}  // namespace

std::string number(double value, bool integral) {
    std::string text = integral ? fixed_text(value) : real_text(value);
    if (!integral && text.find_first_of(".e") == std::string::npos) text += '.';
    return text;
}

std::string name(std::string_view name) {
    if (plain(name) || has_quote(name)) return std::string(name);
    return "\"" + std::string(name) + "\"";
}

std::string shape(const Scene& scene, const Shape& shape, bool wire) {
    return std::visit(
        [&]<class Kind>(const Kind& kind) {
            std::string out = (wire ? "Wire" : "") + std::string(kind.command());
            for_each_field(kind, [&](auto value, bool) {
                if constexpr (std::is_same_v<Kind, VertexList>)
                    out += " " + std::string(topology_name(scene.vertex_lists[value].topology));
                else if constexpr (std::is_same_v<decltype(value), Index>)
                    out += " " + text_of::name(scene.files[value].name);
                else
                    out += " " + number(value, std::is_integral_v<decltype(value)>);
            });
            return out;
        },
        shape);
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
    if (t.encoding) out += *t.encoding == Encoding::srgb ? " srgb" : " raw";
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

namespace snell {
namespace {

constexpr std::array<std::string_view, 12> topologies = {"gl_points",
                                                         "gl_lines",
                                                         "gl_line_strip",
                                                         "gl_line_loop",
                                                         "gl_triangles",
                                                         "gl_triangle_strip",
                                                         "gl_triangle_fan",
                                                         "gl_lines_adjacency",
                                                         "gl_line_strip_adjacency",
                                                         "gl_triangles_adjacency",
                                                         "gl_triangle_strip_adjacency",
                                                         "gl_patches"};

// The word at a place of a list of choices.
std::string_view choice(std::string_view choices, std::size_t place) { return split(choices, '/')[place]; }

}  // namespace

int find_choice(std::string_view choices, std::string_view word) {
    if (choices == "on/off") {
        if (word == "1" || same_word(word, "true")) return 0;
        if (word == "0" || same_word(word, "false")) return 1;
    }
    const std::vector<std::string_view> words = split(choices, '/');
    const auto found = ranges::find_if(words, [&](std::string_view w) { return same_word(w, word); });
    return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

std::optional<Topology> topology_named(std::string_view name) {
    for (std::size_t i = 0; i < topologies.size(); ++i) {
        if (same_word(name, topologies[i])) return static_cast<Topology>(i);
    }
    return std::nullopt;
}

std::string_view topology_name(Topology topology) { return topologies[static_cast<std::size_t>(topology)]; }

const std::vector<std::string_view>& topology_names() {
    static const std::vector<std::string_view> names(topologies.begin(), topologies.end());
    return names;
}

std::string_view blend_factor_name(BlendFactor factor) {
    return choice(SNELL_BLEND_FACTORS, static_cast<std::size_t>(factor));
}

std::string_view cull_face_name(CullFace face) { return choice("none/back/front", static_cast<std::size_t>(face)); }

std::string_view filter_name(Filter::Mode mode) {
    return choice("nearest/linear/mipmap/anisotropic", static_cast<std::size_t>(mode));
}

}  // namespace snell
