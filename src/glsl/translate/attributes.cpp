// Which vertex attribute a vertex shader's input means.
#include <algorithm>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

std::optional<Attribute> by_exact_name(std::string_view name) {
    static const std::vector<AttributeName> names = attribute_names();
    for (const AttributeName& a : names)
        if (a.name == name) return a.attribute;
    return std::nullopt;
}

std::optional<Attribute> by_words(std::string_view name) {
    const std::string s = lowered(name);
    const auto has = [&](std::string_view part) { return s.find(part) != std::string::npos; };
    if (has("bitan") || has("binorm")) return std::nullopt;
    if (has("tang")) return Attribute::tangent;
    if (has("norm")) return Attribute::normal;
    if (has("tex") || has("uv") || s == "st" || s == "ast" || s == "vst") return Attribute::texcoord;
    if (has("col")) return Attribute::color;
    if (has("pos") || has("vert") || has("coord") || s == "p" || s == "v") return Attribute::vertex;
    return std::nullopt;
}

std::optional<Attribute> by_location(const Qualifiers& q) {
    using enum Attribute;
    constexpr Attribute order[] = {vertex, normal, texcoord, color, tangent};
    const int n = q.layout_number("location");
    return n >= 0 && n < 5 ? std::optional(order[n]) : std::nullopt;
}

std::optional<Attribute> legacy_attribute(std::string_view name) {
    if (name == "gl_Vertex" || name == "ftransform") return Attribute::vertex;
    if (name == "gl_Normal") return Attribute::normal;
    if (name == "gl_Color") return Attribute::color;
    if (name.starts_with("gl_MultiTexCoord")) return Attribute::texcoord;
    if (name == "gl_SecondaryColor") return Attribute::secondary_color;
    if (name == "gl_FogCoord") return Attribute::fog_coord;
    return std::nullopt;
}

// The value of a canonical attribute as a variable of the user's type.
std::string value_as(Attribute a, const Type& type) {
    const AttributeFacts& c = attribute_facts()[static_cast<std::size_t>(a)];
    if (type.dims || type.cols > 1 || !type.basic()) return {};
    const std::string type_text(type_name(type.base, type.rows, 1));
    std::string components(c.name);
    if (c.rows > 1 && type.rows < c.rows) components += std::string(".xyzw").substr(0, 1u + type.rows);
    if (type.rows > c.rows) {
        components = type_text + "(" + components;
        for (int n = c.rows; n < type.rows; ++n) components += ", 0.0";  // a direction has no place: w = 0
        return components + ")";
    }
    return type.base == Base::real ? components : type_text + "(" + components + ")";
}

int location_of(const Global& g) { return g.qualifiers.layout_number("location"); }

// Colours that the shader does not write are zero, instead of what another program has left.
void give_colors(Unit& u, const std::vector<Global*>& outputs, int targets) {
    for (const Global* g : outputs)
        if (g->type.dims > 0) return;
    if (outputs.size() == 1 && !outputs.front()->written)
        at_main_start(u, std::string(u.now(outputs.front()->name_token)) + " = " + zero(outputs.front()->type) + ";");
    for (int n = 0; n < targets; ++n) {
        const bool there = ranges::any_of(outputs, [&](const Global* g) {
            return std::max(location_of(*g), 0) == n && (g->written || outputs.size() == 1);
        });
        const std::string name = "snell_Unwritten" + std::to_string(n);
        if (there || !at_main_start(u, name + " = vec4(0.0);")) continue;
        declare_once(u, name, "layout(location = " + std::to_string(n) + ") out vec4 " + name + ";");
    }
}

}  // namespace

std::optional<Attribute> attribute_of(const Global& input) {
    std::optional<Attribute> a = by_exact_name(input.name);
    if (!a) a = by_words(input.name);
    return a ? a : by_location(input.qualifiers);
}

void assign_attributes(Program& program, Unit& u) {
    std::array<int, attribute_count> users{};
    for (const Token& t : u.tokens)
        if (t.kind == Kind::identifier && (t.text.starts_with("gl_") || t.text == "ftransform"))
            if (const auto a = legacy_attribute(t.text)) users[static_cast<std::size_t>(*a)] = 1;
    struct Input {
        Global* global;
        std::optional<Attribute> attribute;
    };
    std::vector<Input> inputs;
    for (Global& g : u.globals) {
        if (g.qualifiers.storage != Storage::in || g.removed || g.name.starts_with("gl_")) continue;
        const std::optional<Attribute> a = attribute_of(g);
        inputs.push_back({&g, a});
        if (a) ++users[static_cast<std::size_t>(*a)];
    }
    for (const Input& input : inputs) {
        Global& g = *input.global;
        const std::string name(u.now(g.name_token));
        if (!input.attribute) {
            if (!g.uses.empty())
                program.warn(u, g.name_token, "unknown-attribute",
                             "no geometry gives a vertex attribute '" + name + "': it is read as zero");
            g.qualifiers = {};
            g.dirty = true;
            if (g.type.dims == 0 && g.type.basic()) at_main_start(u, name + " = " + zero(g.type) + ";", g.name_token);
            continue;
        }
        const Attribute a = *input.attribute;
        g.attribute = static_cast<int>(a);
        const bool known = by_exact_name(g.name) == a;
        const bool widened = (a == Attribute::normal || a == Attribute::tangent) && g.type.rows > 3;
        const bool plain = g.type.base == Base::real && g.type.cols == 1 && g.type.dims == 0 && !widened;
        if (g.qualifiers.erase_layout("location")) g.dirty = true;
        if (known && plain && users[static_cast<std::size_t>(a)] == 1) continue;
        const std::string value = value_as(a, g.type);
        if (value.empty()) continue;
        const AttributeFacts& c = attribute_facts()[static_cast<std::size_t>(a)];
        if (g.name == c.name) continue;
        declare_once(u, c.name, "in " + std::string(c.type) + " " + std::string(c.name) + ";");
        g.qualifiers = {};
        g.dirty = true;
        at_main_start(u, name + " = " + value + ";", g.name_token);
    }
}

void assign_outputs(Program& program, Unit& u) {
    const bool legacy = mentions(u, "gl_FragColor") || mentions(u, "gl_FragData");
    std::vector<Global*> outputs;
    for (Global& g : u.globals)
        if (g.qualifiers.storage == Storage::out && !g.removed && !g.name.starts_with("gl_")) outputs.push_back(&g);
    const auto located =
        std::count_if(outputs.begin(), outputs.end(), [](const Global* g) { return location_of(*g) >= 0; });
    const bool known = outputs.size() < 2 || located == static_cast<std::ptrdiff_t>(outputs.size());
    if (!legacy && known) give_colors(u, outputs, program.options.color_outputs);
    int next = legacy ? 1 : 0;
    for (Global* g : outputs) {
        if ((!g->written && outputs.size() + (legacy ? 1 : 0) > 1) || (legacy && location_of(*g) == 0)) {
            if (legacy && g->written)
                program.warn(
                    u, g->name_token, "two-outputs",
                    "'" + std::string(g->name) + "' is written in addition to gl_FragColor, which is what is shown");
            g->qualifiers = {};
            g->dirty = true;
            continue;
        }
        const bool several = outputs.size() > 1 || legacy;
        if (location_of(*g) < 0 && several && located == 0) {
            g->qualifiers.layout.push_back({"location", std::to_string(next++)});
            g->dirty = true;
        }
        // Missing components of a colour are undefined: alpha must not be.
        if (g->type.base == Base::real && g->type.dims == 0 && g->type.rows < 4 && g->type.cols == 1 && find_main(u)) {
            const std::string name(u.now(g->name_token));
            const std::string out = "snell_out_" + name;
            const int at = std::max(location_of(*g), 0);
            declare_once(u, out, "layout(location = " + std::to_string(at) + ") out vec4 " + out + ";");
            g->qualifiers = {};
            g->dirty = true;
            const std::string value = g->type.rows == 3   ? name
                                      : g->type.rows == 2 ? name + ", 0.0"
                                                          : name + ", 0.0, 0.0";
            at_main_end(u, out + " = vec4(" + value + ", 1.0);");
        }
    }
}

}  // namespace snell::glsl
