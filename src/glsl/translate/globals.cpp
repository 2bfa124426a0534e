// Global variables: initialisers that are no constants, and declarations as the target wants them.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

// In the order of Storage.
constexpr std::string_view storage_words[] = {"", "const ", "in ", "out ", "inout ", "uniform ", "buffer ", "shared "};

std::string qualifier_text(const Qualifiers& q) {
    std::string out;
    if (q.invariant) out += "invariant ";
    if (q.precise) out += "precise ";
    if (!q.layout.empty()) {
        out += "layout(";
        for (std::size_t n = 0; n < q.layout.size(); ++n)
            out += (n ? ", " : "") + q.layout[n].name + (q.layout[n].value.empty() ? "" : " = " + q.layout[n].value);
        out += ") ";
    }
    if (!q.interpolation.empty()) out += std::string(q.interpolation) + " ";
    if (!q.auxiliary.empty()) out += std::string(q.auxiliary) + " ";
    out += std::string(storage_words[static_cast<std::size_t>(q.storage)]) + q.memory;
    if (!q.precision.empty()) out += std::string(q.precision) + " ";
    return out;
}

// The words of a qualifier in the order that versions before 4.20 want.
bool in_order(const Unit& u, const Qualifiers& q) {
    int last = 0, open = 0;
    for (int k = q.first; k <= q.last; ++k) {
        const std::string_view t = u.at(k).text;
        if (t == "(") ++open;
        if (t == ")") --open;
        if (open || t == ")") continue;
        const int rank = t == "invariant" || t == "precise"                     ? 1
                         : t == "layout"                                        ? 1
                         : t == "flat" || t == "smooth" || t == "noperspective" ? 2
                         : t == "centroid" || t == "sample" || t == "patch"     ? 3
                         : t == "highp" || t == "mediump" || t == "lowp"        ? 5
                                                                                : 4;
        if (rank < last) return false;
        last = rank;
    }
    return true;
}

// Sets a field of the declaration, which is written again if that changes it.
template <class Field>
void set(Global& g, Field& field, const Field& value) {
    if (field == value) return;
    field = value;
    g.dirty = true;
}

void adjust_interface(const Target& target, const Unit& u, Global& g) {
    using namespace std::string_view_literals;
    Qualifiers& q = g.qualifiers;
    const bool input = q.storage == Storage::in, output = q.storage == Storage::out;
    const bool vertex_input = u.stage == Stage::vertex && input, fragment_input = u.stage == Stage::fragment && input;
    const bool color_output = u.stage == Stage::fragment && output;
    const bool located = vertex_input || color_output || (target.es ? target.version >= 310 : target.version >= 410);
    if (!located && q.erase_layout("location")) g.dirty = true;
    if (!located && q.erase_layout("component")) g.dirty = true;
    if (target.version < 420 || fragment_input || vertex_input) set(g, q.invariant, false);
    const bool whole = g.type.integral() || (fragment_input && g.type.base == Base::dreal);
    if (whole && (fragment_input || (target.es && u.stage == Stage::vertex && output)))
        set(g, q.interpolation, "flat"sv);
    if (vertex_input || color_output) set(g, q.interpolation, ""sv);
}

// The texture units that a sampler's layout(binding) names become its default where the target has no bindings.
void keep_binding(Program& program, const Global& g) {
    if (g.type.base != Base::sampler || g.removed) return;
    const int first = g.qualifiers.layout_number("binding");
    if (first < 0 || ranges::find(program.defaults, g.name, &UniformDefault::name) != program.defaults.end()) return;
    UniformDefault units{std::string(g.name), {}};
    for (int n = 0; n < (g.type.dims ? std::max(g.type.size, 1) : 1); ++n) units.values.push_back(first + n);
    program.defaults.push_back(std::move(units));
}

void adjust(Program& program, const Unit& u, Global& g) {
    const Target& target = program.target();
    Qualifiers& q = g.qualifiers;
    if (!target.has_precise()) set(g, q.precise, false);
    if (q.attribute || q.varying) g.dirty = true;
    if (q.constant && q.storage != Storage::constant && q.storage != Storage::plain) {
        program.warn(u, g.name_token, "const-interface",
                     "'const' has no meaning for '" + std::string(g.name) + "', which comes from outside: left out");
        g.dirty = true;
    }
    if (q.storage == Storage::in || q.storage == Storage::out) adjust_interface(target, u, g);
    if (q.storage == Storage::uniform) {
        const bool binding = target.es ? target.version >= 310 : target.version >= 420;
        if (!binding) keep_binding(program, g);
        if (!binding && q.erase_layout("binding")) g.dirty = true;
        const bool location = target.es ? target.version >= 310 : target.version >= 430;
        if (!location && q.erase_layout("location")) g.dirty = true;
        set(g, q.interpolation, std::string_view());
        set(g, q.invariant, false);
    }
    const bool ordered = target.es ? target.version >= 310 : target.version >= 420;
    if (!ordered && q.first >= 0 && q.first <= q.last && !in_order(u, q)) g.dirty = true;
    if (g.drop_init || g.removed || !g.new_type.empty() || !g.new_name.empty()) g.dirty = true;
}

void rewrite(Unit& u, const Group& group) {
    std::string text;
    bool first = true;
    const std::string type = render(u, group.type_first, group.type_last);
    for (const int index : group.globals) {
        const Global& g = u.globals[static_cast<std::size_t>(index)];
        if (g.removed) continue;
        const std::string type_text = !g.new_type.empty()              ? g.new_type
                                      : group.defines_struct && !first ? std::string(g.type.name)
                                                                       : type;
        if (!text.empty()) text += ' ';
        text += qualifier_text(g.qualifiers) + type_text + " ";
        text += g.new_name.empty() ? std::string(u.now(g.name_token)) : g.new_name;
        text += g.dims;
        if (g.init_first >= 0 && !g.drop_init)
            text += " = " + render(u, g.init_first, g.init_last);
        else if (!g.initial.empty())
            text += " = " + g.initial;
        text += ';';
        first = false;
    }
    // Clear the edits within, keep the line ends.
    for (int k = group.first; k <= group.last; ++k) {
        Edit& e = u.edit(k);
        e = Edit{};
        e.replaced = true;
        if (k == group.first) e.text = text;
    }
}

// `invariant A, B;`, less what passes between no stages any more, what is ours, and inputs: only versions before 4.20
// want the word on both sides. The same of `precise`, where the target has it; of both, one statement each, because
// some drivers take no two words.
void write_redeclared(const Target& target, Unit& u, int first, int last) {
    const auto stays = [&](std::string_view name) {
        if (const LegacyName* legacy = legacy_name(name)) return legacy->kind == LegacyKind::core;
        const auto global = ranges::find(u.globals, name, &Global::name);
        if (global == u.globals.end() || global->qualifiers.storage == Storage::out) return true;
        return global->qualifiers.storage == Storage::in && !target.es && target.version < 420;
    };
    std::vector<std::string_view> words;
    std::string names, text;
    bool same = true;
    for (int k = first; k < last; ++k) {
        const std::string_view name = u.at(k).text;
        if (u.at(k).kind != Kind::identifier) continue;
        if (name == "invariant" || name == "precise")
            words.push_back(name);
        else if (stays(name))
            names += (names.empty() ? "" : ", ") + std::string(u.now(k));
        else
            same = false;
    }
    for (const std::string_view word : words)
        if (word == "invariant" || target.has_precise()) text += fmt::format("{} {};", word, names);
    if (same && words.size() == 1 && !text.empty()) return;
    u.erase(first, last);
    if (!names.empty()) u.replace(first, text);
}

}  // namespace

void move_initialisers(Program& program, Unit& u) {
    if (!find_main(u)) return;
    const auto line_of = [&](int token) {
        const Span span = u.span(token);
        return "\n#line " + std::to_string(program.sources.position(span.file, span.begin).line) + " " +
               std::to_string(u.at(token).file) + "\n";
    };
    for (Global& g : u.globals) {
        const bool variable = g.qualifiers.storage == Storage::plain || g.qualifiers.storage == Storage::constant;
        const bool output = g.qualifiers.storage == Storage::out;
        if (g.init_first < 0 || g.drop_init || g.removed || (!output && (!variable || g.init_constant))) continue;
        if (u.groups[static_cast<std::size_t>(g.group)].last < 0) continue;
        if (g.qualifiers.storage == Storage::constant) {
            g.qualifiers.storage = Storage::plain;
            if (g.init_fits)
                program.warn(
                    u, g.name_token, "const-not-constant",
                    "the value of '" + std::string(g.name) + "' is not a constant: computed at the start of main");
        }
        if (u.now(g.init_first) == "{" && g.type.dims == 1) {
            u.replace(g.init_first, std::string(g.type.name) + "[](");
            u.replace(g.init_last, ")");
        }
        if (g.dims == "[]" && g.type.size > 0) g.dims = "[" + std::to_string(g.type.size) + "]";
        // What is wrong with it is wrong where it is written.
        at_main_start(u,
                      line_of(g.init_first) + std::string(u.now(g.name_token)) + " = " +
                          render(u, g.init_first, g.init_last) + ";" + line_of(find_main(u)->open),
                      g.name_token);
        g.drop_init = true;
        g.dirty = true;
    }
}

void write_declarations(Program& program, Unit& u) {
    for (const auto& [first, last] : u.redeclared) write_redeclared(program.target(), u, first, last);
    for (Global& g : u.globals) adjust(program, u, g);
    for (const Group& group : u.groups) {
        if (group.last < 0) continue;
        const bool dirty = std::any_of(group.globals.begin(), group.globals.end(),
                                       [&](int n) { return u.globals[static_cast<std::size_t>(n)].dirty; });
        if (dirty) rewrite(u, group);
    }
}

}  // namespace snell::glsl
