// Lines wider than the driver draws: a geometry stage that makes a quad of each and hands every varying on.
#include <algorithm>

#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// The line in pixels is widened to both sides by half the width. What lies behind the eye or the near plane is
// cut away first, as GL does: there x / w means nothing. Corners keep their w, so the rasteriser interpolates
// with perspective along the line; `t` is the place on the line as it was given, 0 … 1.
constexpr std::string_view main_text = R"(
void snell_cut(float a, float b, inout vec2 part) {
    if (a < 0.0 && b < 0.0) part = vec2(1.0, 0.0);
    else if (a < 0.0) part.x = max(part.x, a / (a - b));
    else if (b < 0.0) part.y = min(part.y, a / (a - b));
}

void main() {
    vec4 a = gl_in[0].gl_Position, b = gl_in[1].gl_Position;
    vec2 part = vec2(0.0, 1.0);
    snell_cut(a.w - 1e-6, b.w - 1e-6, part);
    snell_cut(a.z + a.w, b.z + b.w, part);
    if (!(part.x < part.y)) return;
    vec4 from = mix(a, b, part.x), to = mix(a, b, part.y);
    vec2 along = (to.xy / to.w - from.xy / from.w) * snell_Viewport;
    float pixels = length(along);
    if (!(pixels > 0.0)) return;
    vec2 across = vec2(-along.y, along.x) / pixels * max(snell_LineWidth, 1.0) / snell_Viewport;
    snell_corner(from, -across, part.x);
    snell_corner(to, -across, part.y);
    snell_corner(from, across, part.x);
    snell_corner(to, across, part.y);
    EndPrimitive();
}
)";

// What stands before a member of an interface block, in the geometry stage: "snell_from[0]." and "snell_to.".
struct Ends {
    std::string first, second, out;

    Ends member(const std::string& tail) const { return {first + tail, second + tail, out + tail}; }
};

class Widener {
public:
    Widener(Program& program, Unit& vertex, Unit& fragment)
        : program_(program), vertex_(vertex), fragment_(fragment), es_(program.target().es) {}

    std::optional<std::string> make() {
        const std::vector<Pair> pairs = match_variables();
        match_blocks();
        if (!possible_) return std::nullopt;
        for (const Pair& pair : pairs) pass(pair);
        if (!members_.empty()) join();
        pass_legacy();
        return text();
    }

private:
    struct Pair {
        Global* out;
        Global* in;
    };

    std::vector<Pair> match_variables() {
        std::vector<Pair> pairs;
        for (Global& in : fragment_.globals) {
            if (in.qualifiers.storage != Storage::in || in.removed || in.name.starts_with("gl_")) continue;
            const auto given = std::find_if(vertex_.globals.begin(), vertex_.globals.end(), [&](const Global& out) {
                if (out.qualifiers.storage != Storage::out || out.removed) return false;
                const std::string_view at = in.qualifiers.layout_value("location");
                return out.name == in.name || (!at.empty() && out.qualifiers.layout_value("location") == at);
            });
            possible_ = possible_ && given != vertex_.globals.end() && passable(vertex_, given->type);
            if (possible_) pairs.push_back({&*given, &in});
        }
        return pairs;
    }

    bool passable(const Unit& u, const Type& type) const {
        if (type.dims > 1 || (type.dims == 1 && type.size <= 0)) return false;
        if (type.base != Base::structure) return type.basic();
        if (type.structure < 0) return false;
        const Struct& s = u.structure(type);
        return std::all_of(s.members.begin(), s.members.end(), [&](const Member& m) { return passable(u, m.type); });
    }

    std::string declaration(const Type& type, std::string_view name) {
        std::string text;
        if (type.base == Base::structure) {
            define(type.structure);
            text = vertex_.structure(type).name;
        } else {
            text = (es_ && type.base != Base::boolean ? "highp " : "") +
                   std::string(type_name(type.base, type.rows, type.cols));
        }
        text += " " + std::string(name);
        return text + (type.dims ? "[" + std::to_string(type.size) + "];" : ";");
    }

    void define(int structure) {
        if (!defined_.insert(structure).second) return;
        const Struct& s = vertex_.structs[static_cast<std::size_t>(structure)];
        std::string text = "struct " + std::string(s.name) + " {";
        for (const Member& m : s.members) text += " " + declaration(m.type, m.name);
        structs_ += text + " };\n";
    }

    // Statements that set `ends.out` to the value at t. Whole numbers are the last vertex's, as flat ones are.
    std::string between(const Unit& u, const Ends& ends, Type type, bool flat, int depth = 0) {
        if (flat || type.integral() || type.base == Base::boolean || type.base == Base::dreal)
            return "    " + ends.out + " = " + ends.second + ";\n";
        if (type.dims) {
            const std::string i = "snell_i" + std::to_string(depth);
            const std::string size = std::to_string(type.size);
            type.dims = 0;
            return "    for (int " + i + " = 0; " + i + " < " + size + "; ++" + i + ") {\n" +
                   between(u, ends.member("[" + i + "]"), type, flat, depth + 1) + "    }\n";
        }
        if (type.base != Base::structure)
            return "    " + ends.out + " = " + ends.first + " * (1.0 - t) + " + ends.second + " * t;\n";
        std::string text;
        for (const Member& m : u.structure(type).members)
            text += between(u, ends.member("." + std::string(m.name)), m.type, flat, depth);
        return text;
    }

    // A varying becomes a global variable in its stages; a member of the block between them takes its value.
    void pass(const Pair& pair) {
        const std::string out(vertex_.now(pair.out->name_token)), in(fragment_.now(pair.in->name_token));
        const Type& type = pair.out->type;
        const bool whole = type.integral() || type.base == Base::dreal;
        std::string how(whole ? std::string_view("flat") : pair.in->qualifiers.interpolation);
        if (!how.empty()) how += ' ';
        if (!pair.in->qualifiers.auxiliary.empty()) how += std::string(pair.in->qualifiers.auxiliary) + " ";
        members_ += " " + how + declaration(type, in);
        copies_ += between(vertex_, {"snell_from[0]." + in, "snell_from[1]." + in, "snell_to." + in}, type,
                           how.starts_with("flat"));
        vertex_copies_ += " snell_line." + in + " = " + out + ";";
        fragment_copies_ += in + " = snell_line." + in + "; ";
        for (const auto& [u, g] : {std::pair{&vertex_, pair.out}, std::pair{&fragment_, pair.in}}) {
            const std::string_view precision = g->qualifiers.precision;
            const Qualifiers old = g->qualifiers;
            g->qualifiers = {};
            g->qualifiers.precision = precision;
            g->qualifiers.first = old.first;
            g->qualifiers.last = old.last;
            // The text may read it above the statement that sets it, or never set it: drivers warn of either.
            g->initial = zero_of(u->structs, g->type);
            g->dirty = true;
        }
    }

    void join() {
        const std::string block = " snell_Line {" + members_ + " } ";
        declarations_ += "in" + block + "snell_from[];\nout" + block + "snell_to;\n";
        at_main_end(vertex_, vertex_copies_.substr(1));
        declare_before_main(vertex_, "out" + block + "snell_line;\n", "");
        declare_before_main(fragment_, "in" + block + "snell_line;\n", fragment_copies_);
    }

    void match_blocks() {
        for (const Block& in : fragment_.blocks) {
            if (in.qualifiers.storage != Storage::in || in.name == "gl_PerVertex") continue;
            const auto out = std::find_if(vertex_.blocks.begin(), vertex_.blocks.end(), [&](const Block& b) {
                return b.qualifiers.storage == Storage::out && b.name == in.name;
            });
            possible_ = possible_ && out != vertex_.blocks.end() && !in.arrayed && !out->arrayed &&
                        in.qualifiers.layout.empty() && out->qualifiers.layout.empty() &&
                        in.members.size() == out->members.size();
            if (possible_) pass(*out, in);
        }
    }

    // A block keeps its name on both sides.
    void pass(const Block& given, const Block& taken) {
        const std::string name(given.name);
        std::string in = "in " + name + " {", out = "out " + name + " {";
        for (std::size_t n = 0; n < given.members.size(); ++n) {
            const Member& m = given.members[n];
            if (!passable(vertex_, m.type)) {
                possible_ = false;
                return;
            }
            if (m.type.base == Base::structure) define(m.type.structure);
            const auto [first, last] = taken.member_tokens[n];
            in += " " + render(vertex_, given.member_tokens[n].first, given.member_tokens[n].second);
            out += " " + render(fragment_, first, last);
            bool flat = false;
            for (int k = first; k <= last; ++k) flat = flat || fragment_.at(k).text == "flat";
            const std::string from = "snell_from_" + name, member(m.name);
            const std::string to = taken.instance.empty() ? member : "snell_to_" + name + "." + member;
            copies_ += between(vertex_, {from + "[0]." + member, from + "[1]." + member, to}, m.type, flat);
        }
        declarations_ += in + " } snell_from_" + name + "[];\n" + out + " }" +
                         (taken.instance.empty() ? std::string() : " snell_to_" + name) + ";\n";
    }

    void pass_legacy() {
        if (program_.legacy_varyings.empty()) return;
        std::string members;
        for (const LegacyVarying& v : program_.legacy_varyings) {
            members += " " + v.declaration;
            Type type;
            type.base = Base::real;
            type.dims = v.size > 0 ? 1 : 0;
            type.size = v.size;
            copies_ += between(vertex_, {"snell_in[0]." + v.name, "snell_in[1]." + v.name, v.name}, type,
                               v.declaration.starts_with("flat "));
        }
        declarations_ += "in snell_PerVertex {" + members + " } snell_in[];\nout snell_PerVertex {" + members + " };\n";
    }

    std::string text() const {
        const Target& target = program_.target();
        std::string text = "#version " + std::to_string(target.version) + (es_ ? " es\n" : " core\n");
        if (es_) text += "precision highp float;\nprecision highp int;\n";
        text +=
            "layout(lines) in;\nlayout(triangle_strip, max_vertices = 4) out;\nuniform float snell_LineWidth;\n"
            "uniform vec2 snell_Viewport;\n" +
            structs_ + declarations_ + "\nvoid snell_corner(vec4 position, vec2 aside, float t) {\n" + copies_;
        if (mentions(fragment_, "gl_PrimitiveID")) text += "    gl_PrimitiveID = gl_PrimitiveIDIn;\n";
        text +=
            "    gl_Position = vec4(position.xy + aside * position.w, position.zw);\n    EmitVertex();\n"
            "}\n";
        return text + std::string(main_text);
    }

    Program& program_;
    Unit& vertex_;
    Unit& fragment_;
    const bool es_;
    bool possible_ = true;
    std::string members_, vertex_copies_, fragment_copies_;  // of variables
    std::string structs_, declarations_, copies_;            // of the geometry stage
    std::set<int> defined_;
};

}  // namespace

bool widens_lines(const Program& program) {
    const Target& target = program.target();
    return program.options.wide_lines && program.units.size() == 2 && (!target.es || target.version >= 320);
}

std::optional<std::string> widen_lines(Program& program) {
    if (!widens_lines(program)) return std::nullopt;
    Unit& vertex = program.units.front();
    auto text = Widener(program, vertex, program.units.back()).make();
    if (!text)
        program.diagnostics.warning("thin-lines", vertex.reference,
                                    "lines stay thin: this OpenGL draws no wide ones, and what passes between the "
                                    "shaders is too intricate to be handed on");
    return text;
}

}  // namespace snell::glsl
