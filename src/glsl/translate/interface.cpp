// Inputs of each stage are matched by name with the outputs of the stage before.
#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

bool builtin(const Global& g) { return g.name.starts_with("gl_"); }

// The type of one vertex's value: inputs of these stages, and outputs of tessellation control, are arrays.
Type per_vertex(const Unit& u, const Global& g) {
    Type t = g.type;
    const bool input = g.qualifiers.storage == Storage::in;
    const bool arrayed =
        input ? u.stage == Stage::tess_control || u.stage == Stage::tess_evaluation || u.stage == Stage::geometry
              : u.stage == Stage::tess_control;
    if (arrayed && g.qualifiers.auxiliary != "patch" && t.dims > 0) --t.dims;
    return t;
}

Global* find_output(Unit& u, std::string_view name) {
    for (Global& g : u.globals)
        if (g.qualifiers.storage == Storage::out && g.name == name && !g.removed) return &g;
    return nullptr;
}

bool in_block(const Unit& u, Storage storage, std::string_view name) {
    for (const Block& b : u.blocks)
        if (b.qualifiers.storage == storage && b.instance.empty() &&
            std::any_of(b.members.begin(), b.members.end(), [&](const Member& m) { return m.name == name; }))
            return true;
    return false;
}

// With a size for each vertex of the primitive where none is written.
std::string element_dims(const Unit& u, const std::string& dims) {
    if (dims != "[]") return dims;
    return "[" + std::to_string(u.stage == Stage::geometry ? vertices_in(u) : 32) + "]";
}

void warn_of_zero(Program& program, const Unit& u, int token, std::string_view name, const Unit& from) {
    program.warn(u, token, "input-without-output",
                 "'" + std::string(name) + "' is not an output of the " + std::string(stage_name(from.stage)) +
                     " shader: it is read as zero");
}

void read_as_zero(Program& program, Unit& u, Global& g, const Unit& from) {
    if (!g.uses.empty()) warn_of_zero(program, u, g.name_token, g.name, from);
    if (!g.type.basic() && g.type.structure < 0) return;
    Qualifiers plain;
    plain.first = g.qualifiers.first;
    plain.last = g.qualifiers.last;
    g.qualifiers = plain;
    g.dirty = true;
    Type sized = g.type;
    if (g.dims == "[]") sized.size = 1;
    g.dims = element_dims(u, g.dims);
    at_main_start(u, set_zero(u, std::string(u.now(g.name_token)), sized), g.name_token);
}

// A block becomes a structure of that instance, or its members become variables.
void read_as_zero(Program& program, Unit& u, Block& b, const Unit& from) {
    warn_of_zero(program, u, b.open - 1, b.name, from);
    b.qualifiers.storage = Storage::plain;
    u.erase(b.first, b.open - 1);
    unqualify_members(u, b);
    std::string start, before, after;
    if (b.instance.empty()) {
        u.erase(b.open, b.open);
        u.erase(b.close, b.last);
    } else {
        u.replace(b.first, "struct snell_" + std::string(b.name) + " ");
        before = std::string(b.instance) + ".";
    }
    if (b.arrayed) {
        for (int k = b.close; k < b.last; ++k)
            if (u.at(k).text == "[" && u.at(k + 1).text == "]") {
                const std::string size = element_dims(u, "[]");
                u.replace(k, size.substr(0, size.size() - 1));
            }
        start = "for (int snell_n = 0; snell_n < " + before + "length(); ++snell_n) { ";
        before = std::string(b.instance) + "[snell_n].";
        after = "}";
    }
    for (const Member& m : b.members) start += set_zero(u, before + std::string(m.name), m.type) + " ";
    at_main_start(u, start + after, b.last);
}

// Varyings declared with two types: the input is declared as the output is, its uses converted.
void adapt_type(Program& program, Unit& u, Global& in, const Type& output) {
    const Type own = per_vertex(u, in);
    if (own.same(output) || own.dims || output.dims || in.type.dims) return;
    const std::string name(u.now(in.name_token));
    const std::string use = converted(name, output, own);
    if (use.empty()) return;
    program.warn(
        u, in.name_token, "varying-types",
        "'" + name + "' is " + std::string(own.name) + " here, but the stage before gives " + std::string(output.name));
    in.new_type = output.name;
    in.dirty = true;
    in.type = output;
    for (const int token : in.uses) u.replace(token, use);
}

void adapt_interpolation(const Target& target, Unit& from, Global& out, Unit& to, Global& in) {
    if (to.stage != Stage::fragment) return;
    if ((in.type.integral() || in.type.base == Base::dreal || in.type.base == Base::boolean) &&
        in.qualifiers.interpolation != "flat") {
        in.qualifiers.interpolation = "flat";
        in.dirty = true;
    }
    const std::string_view a = in.qualifiers.interpolation == "smooth" ? "" : in.qualifiers.interpolation;
    const std::string_view b = out.qualifiers.interpolation == "smooth" ? "" : out.qualifiers.interpolation;
    if (a != b && (target.es || target.version < 440 || from.stage != Stage::vertex)) {
        out.qualifiers.interpolation = in.qualifiers.interpolation;
        out.dirty = true;
    }
    if (in.qualifiers.auxiliary != out.qualifiers.auxiliary && (target.es || target.version < 430)) {
        out.qualifiers.auxiliary = in.qualifiers.auxiliary;
        out.dirty = true;
    }
}

// `out` where `in` was meant: never written here, given by the stage before. And the reverse in a vertex shader.
void turn_around(Program& program, Unit& from, Unit& u) {
    for (Global& g : u.globals) {
        if (g.qualifiers.storage != Storage::out || g.written || g.uses.empty() || u.stage != Stage::fragment) continue;
        const Global* given = find_output(from, g.name);
        if (!given || !given->type.same(g.type)) continue;
        program.warn(u, g.name_token, "direction", "'" + std::string(g.name) + "' is never written: taken as an input");
        g.qualifiers.storage = Storage::in;
        g.qualifiers.layout.clear();
        g.dirty = true;
    }
    if (from.stage != Stage::vertex) return;
    for (Global& g : from.globals) {
        if (g.qualifiers.storage != Storage::in || !g.written || find_output(from, g.name)) continue;
        const bool wanted = std::any_of(u.globals.begin(), u.globals.end(), [&](const Global& i) {
            return i.qualifiers.storage == Storage::in && i.name == g.name && per_vertex(u, i).same(g.type);
        });
        if (!wanted) continue;
        program.warn(from, g.name_token, "direction", "'" + std::string(g.name) + "' is written: taken as an output");
        g.qualifiers.storage = Storage::out;
        g.qualifiers.layout.clear();
        g.qualifiers.attribute = false;
        g.dirty = true;
    }
}

}  // namespace

void unqualify_members(Unit& unit, const Block& block) {
    for (const auto& [first, last] : block.member_tokens)
        for (int k = first; k <= last && is_qualifier(unit.at(k).text); ++k) {
            const std::string_view word = unit.at(k).text;
            int end = k;
            if (word == "layout")
                while (end < last && unit.at(end).text != ")") ++end;
            if (word != "highp" && word != "mediump" && word != "lowp") unit.erase(k, end);
            k = end;
        }
}

void match_interfaces(Program& program) {
    for (Unit& u : program.units) {
        Unit* from = program.before(u);
        if (!from) continue;
        turn_around(program, *from, u);
        for (Block& b : u.blocks) {
            const bool given = ranges::any_of(
                from->blocks, [&](const Block& o) { return o.qualifiers.storage == Storage::out && o.name == b.name; });
            if (b.qualifiers.storage == Storage::in && !given && !b.name.starts_with("gl_"))
                read_as_zero(program, u, b, *from);
        }
        for (Global& g : u.globals) {
            if (g.qualifiers.storage != Storage::in || builtin(g) || g.removed) continue;
            Global* out = find_output(*from, g.name);
            if (!out) {
                if (in_block(*from, Storage::out, g.name)) continue;
                const std::string_view at = g.qualifiers.layout_value("location");
                const bool by_location =
                    !at.empty() && std::any_of(from->globals.begin(), from->globals.end(), [&](const Global& o) {
                        return o.qualifiers.storage == Storage::out && o.qualifiers.layout_value("location") == at;
                    });
                if (!by_location) read_as_zero(program, u, g, *from);
                continue;
            }
            if (out->qualifiers.layout_value("location") != g.qualifiers.layout_value("location"))
                for (Global* either : {out, &g})
                    if (either->qualifiers.erase_layout("location")) either->dirty = true;
            adapt_type(program, u, g, per_vertex(*from, *out));
            adapt_interpolation(program.target(), *from, *out, u, g);
        }
    }
}

namespace {

// A statement of main itself sets it as a whole, before anything returns. `assigns(i)`: the variable begins at the
// token i and `=` follows. What is already translated has it in snell_main.
template <class Assigns>
bool always_written(const Unit& u, Assigns assigns) {
    const auto wrapped = ranges::find(u.functions, "snell_main", &Function::name);
    const auto written_in = [&](const Function& f) {
        int depth = 0;
        for (int i = f.open; i < f.close; ++i) {
            const std::string_view text = u.at(i).text;
            if (text == "{") ++depth;
            if (text == "}") --depth;
            if (text == "return" || text == "EmitVertex") return false;
            int first = i;  // of `a = b = …`
            while (first > 1 && u.at(first - 1).text == "=") first -= 2;
            const std::string_view before = first > 0 ? u.at(first - 1).text : "";
            if (depth == 1 && (before == ";" || before == "{" || before == "}") && assigns(i)) return true;
        }
        return false;
    };
    const Function* main = find_main(u);
    if (!main || u.has_conditionals) return false;
    return written_in(*main) || (wrapped != u.functions.end() && written_in(*wrapped));
}

bool always_written(const Unit& u, const Global& g) {
    return always_written(u, [&](int i) { return u.at(i + 1).text == "=" && ranges::find(g.uses, i) != g.uses.end(); });
}

void give(Unit& u, const Global& g) {
    if (g.type.dims > 0 && g.name.starts_with("snell_")) return;  // ours, which are given where they are made
    const std::string value = zero_of(u.structs, g.type);
    if (!value.empty() && !always_written(u, g))
        at_main_start(u, std::string(u.now(g.name_token)) + " = " + value + ";", g.name_token);
}

void give(const Program& program, Unit& u, const Block& b) {
    const bool flat = flattens_blocks(program);
    for (const Member& m : b.members) {
        const bool bare = b.instance.empty();
        const auto assigns = [&](int i) {
            const int at = bare ? i : i + 2;
            return (bare || (u.at(i).text == b.instance && u.at(i + 1).text == ".")) && u.at(at).text == m.name &&
                   u.at(at + 1).text == "=";
        };
        const std::string value = zero_of(u.structs, m.type);
        const std::string name = flat ? variable_of(program, b.name, m.name)
                                      : (bare ? "" : std::string(b.instance) + ".") + std::string(m.name);
        if (flat && m.type.dims > 0 && name.starts_with("snell_")) continue;  // as of variables
        if (!value.empty() && !always_written(u, assigns)) at_main_start(u, name + " = " + value + ";");
    }
}

}  // namespace

void give_outputs(const Program& program, Unit& u) {
    for (const Global& g : u.globals) {
        const bool variable = g.qualifiers.storage == Storage::plain && g.type.dims == 0 && g.init_first < 0;
        if (variable && !g.removed && !g.name.starts_with("snell_") && !builtin(g) &&
            (g.type.structure < 0 || !u.structure(g.type).name.starts_with("snell_")))
            give(u, g);
    }
    // What a function gives back that ends without `return`.
    for (const Function& f : u.functions) {
        const std::string value = f.open < 0 || f.name.starts_with("snell") ? "" : zero_of(u.structs, f.result);
        int first = f.close - 1;
        while (first > f.open + 1 && std::string_view(";{}").find(u.at(first - 1).text) == std::string_view::npos)
            --first;
        if (value.empty() || u.at(f.close - 1).macro >= 0 || u.at(first).text == "return") continue;
        u.edit(f.close - 1).after += " return " + value + ";";
        if (program.options.settle) u.marks.push_back({Mark::Kind::kept, -1, -1, -1, f.close - 1});
    }
    const auto assigns_color = [&](int i) { return u.at(i).text == "gl_FragColor" && u.at(i + 1).text == "="; };
    if (u.stage == Stage::fragment && mentions(u, "gl_FragColor") && !mentions(u, "gl_FragData") &&
        !always_written(u, assigns_color))
        at_main_start(u, "snell_FragColor = vec4(0.0);");
    if (u.stage == Stage::tess_control) return;
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == Storage::out && !g.removed && !builtin(g) &&
            (u.stage != Stage::fragment || (g.written && !g.name.starts_with("snell_"))))
            give(u, g);
    if (u.stage == Stage::fragment) return;
    const bool numbered = ranges::any_of(program.units, [](const Unit& other) {
        return other.stage == Stage::fragment && mentions(other, "gl_PrimitiveID");
    });
    if (u.stage == Stage::geometry && numbered) at_main_start(u, "gl_PrimitiveID = 0;");
    for (const Block& b : u.blocks)
        if (b.qualifiers.storage == Storage::out && !b.arrayed && !b.name.starts_with("gl_") &&
            !b.name.starts_with("snell_"))
            give(program, u, b);
}

}  // namespace snell::glsl
