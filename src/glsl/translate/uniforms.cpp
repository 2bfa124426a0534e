// Uniforms: one type and one initialiser across all stages; those that keep their values become constants, so that the
// driver leaves out what they switch off.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "parser/text/ranges.h"
#include "parser/text/real.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"
#include "src/glsl/run/folding.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

struct Seen {
    Unit* unit;
    Global* global;
};

int rank(const Type& t) {
    const int base = t.base == Base::boolean ? 0 : t.base == Base::integer ? 1 : t.base == Base::uinteger ? 2 : 3;
    return t.rows * t.cols * 8 + base;
}

// Makes one declaration like `model`, its uses converted to what they were.
void adapt(Program& program, const Seen& s, const Type& model) {
    Global& g = *s.global;
    const std::string name(s.unit->now(g.name_token));
    const std::string use = converted(name, model, g.type);
    if (use.empty()) return;
    program.warn(*s.unit, g.name_token, "uniform-types",
                 "'" + name + "' is " + std::string(g.type.name) + " here and " + std::string(model.name) +
                     " in another stage: it is read as " + std::string(model.name));
    g.new_type = model.name;
    for (const int token : g.uses) s.unit->replace(token, use);
}

void record(Program& program, const Global& g) {
    if (g.value.empty()) return;
    std::vector<double> values = g.value;
    const std::size_t size = static_cast<std::size_t>(g.type.rows) * g.type.cols;
    if (g.type.dims == 0 && values.size() != size) return;
    program.defaults.push_back({std::string(g.name), std::move(values)});
}

bool same_type(const Type& a, const Type& b) {
    return a.base == b.base && a.rows == b.rows && a.cols == b.cols && a.dims == b.dims;
}

// The same uniform twice in one stage.
void drop_repeated(Program& program, Unit& u) {
    std::map<std::string_view, Global*> seen;
    for (Global& g : u.globals) {
        const Storage s = g.qualifiers.storage;
        if (s != Storage::uniform && s != Storage::in && s != Storage::out) continue;
        const auto [it, fresh] = seen.emplace(g.name, &g);
        if (fresh || it->second->qualifiers.storage != s || !it->second->type.same(g.type) || g.init_first >= 0)
            continue;
        program.warn(u, g.name_token, "declared-twice",
                     "'" + std::string(g.name) + "' is declared twice: once is enough");
        g.removed = true;
        Global& kept = *it->second;
        kept.uses.insert(kept.uses.end(), g.uses.begin(), g.uses.end());
        kept.written = kept.written || g.written;
    }
}

// A redeclared variable of the language, and one element for each vertex, need no size.
bool wants_size(const Unit& u, const Global& g) {
    const bool by_vertex =
        (g.qualifiers.storage == Storage::in && u.stage != Stage::vertex && u.stage != Stage::fragment) ||
        (g.qualifiers.storage == Storage::out && u.stage == Stage::tess_control);
    return g.dims == "[]" && g.init_first < 0 && !by_vertex && !g.name.starts_with("gl_");
}

}  // namespace

void size_arrays(Program& program) {
    if (!program.target().es) return;
    std::map<std::string_view, int> written, indexed;
    for (const Unit& u : program.units)
        for (const Global& g : u.globals) {
            if (g.type.dims == 1) written[g.name] = std::max(written[g.name], g.type.size);
            if (wants_size(u, g)) indexed[g.name] = std::max(indexed[g.name], g.most_index + 1);
        }
    for (Unit& u : program.units) {
        std::set<std::string_view> sized;
        for (Global& g : u.globals) {
            if (!wants_size(u, g)) {  // the declaration that gives the size
                if (sized.contains(g.name) && g.init_first < 0) g.removed = g.dirty = true;
                continue;
            }
            const int size = std::max(written[g.name], g.indexed_freely ? 0 : indexed[g.name]);
            if (size <= 0)
                program.diagnostics.error("array-size", u.span(g.name_token),
                                          "'" + std::string(g.name) + "' has no size, which OpenGL ES wants",
                                          "write the number of elements, as in " + std::string(g.name) + "[4]");
            g.type.size = std::max(size, 1);
            g.dims = "[" + std::to_string(g.type.size) + "]";
            g.dirty = true;
            sized.insert(g.name);
        }
    }
}

void unify_uniforms(Program& program) {
    std::map<std::string_view, std::vector<Seen>> by_name;
    for (Unit& u : program.units) {
        drop_repeated(program, u);
        for (Global& g : u.globals)
            if (g.qualifiers.storage == Storage::uniform && !g.removed) by_name[g.name].push_back({&u, &g});
    }
    for (auto& [name, seen] : by_name) {
        const Seen* model = &seen.front();
        for (const Seen& s : seen)
            if (s.global->type.base <= Base::dreal && rank(s.global->type) > rank(model->global->type)) model = &s;
        const Global* initial = nullptr;
        for (const Seen& s : seen) {
            Global& g = *s.global;
            if (!same_type(g.type, model->global->type)) adapt(program, s, model->global->type);
            if (g.init_first < 0) continue;
            if (!g.init_constant) {
                program.warn(*s.unit, g.name_token, "uniform-initialiser",
                             "the initial value of a uniform must be a constant: left out");
                g.drop_init = true;
                continue;
            }
            if (!initial) {
                initial = &g;
                record(program, g);
            } else if (g.value.empty() || g.value != initial->value) {
                g.drop_init = true;
                if (g.value != initial->value)
                    program.warn(
                        *s.unit, g.name_token, "uniform-initialiser",
                        "'" + std::string(name) + "' has another initial value in an earlier stage, which counts");
            }
            if (!g.new_type.empty() || program.target().es) g.drop_init = true;
        }
    }
}

// ---- settled uniforms --------------------------------------------------------------------------------------

namespace {

template <class Real>
std::string literal(double value, std::string_view suffix) {
    std::string text = real_text(static_cast<Real>(value));
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + std::string(suffix);
}

// False for what a decimal does not give on every driver: zeros of negative sign, numbers that are too small to be
// normal, and those that are not finite.
template <class Real>
bool exact(double value) {
    const Real real = static_cast<Real>(value);
    return std::isnormal(real) || (real == 0 && !std::signbit(real));
}

// The text of one component, as the uniform would hold it; empty if there is none.
std::string component_text(Base base, double value) {
    using Int = std::numeric_limits<std::int32_t>;
    using Uint = std::numeric_limits<std::uint32_t>;
    switch (base) {
        case Base::boolean:
            return std::abs(value) >= 1 ? "true" : "false";
        case Base::integer:  // the least integer is no literal
            return value > Int::min() && value <= Int::max() ? std::to_string(static_cast<std::int32_t>(value)) : "";
        case Base::uinteger:
            return value >= 0 && value <= Uint::max() ? std::to_string(static_cast<std::uint32_t>(value)) + "u" : "";
        case Base::real:
            return std::abs(value) <= std::numeric_limits<float>::max() && exact<float>(value)
                       ? literal<float>(value, "")
                       : "";
        case Base::dreal:
            return exact<double>(value) ? literal<double>(value, "lf") : "";
        default:
            return "";
    }
}

std::string constant_text(const Type& type, const std::vector<double>& values) {
    if (values.size() != static_cast<std::size_t>(type.rows) * type.cols) return {};
    std::string text;
    for (const double value : values) {
        const std::string component = component_text(type.base, value);
        if (component.empty()) return {};
        text += (text.empty() ? "" : ", ") + component;
    }
    return type.scalar() ? text : std::string(type_name(type.base, type.rows, type.cols)) + "(" + text + ")";
}

std::string scene_name(const Program& program, const Global& g) {
    const auto renamed = ranges::find(program.renamed, g.name, &RenamedUniform::shader_name);
    return renamed == program.renamed.end() ? std::string(g.name) : renamed->name;
}

bool is_uniform(const Global& g) { return g.qualifiers.storage == Storage::uniform && !g.removed; }

const Global* declaration(const Program& program, std::string_view name) {
    for (const Unit& u : program.units)
        for (const Global& g : u.globals)
            if (is_uniform(g) && scene_name(program, g) == name) return &g;
    return nullptr;
}

}  // namespace

namespace {

// By the shader's names.
std::map<std::string_view, run::Fold> folds(const Program& program) {
    using Kind = run::Fold::Kind;
    std::map<std::string_view, run::Fold> settled;
    for (std::size_t n = 0; n < program.settled.size(); ++n) {
        const Settled& one = program.settled[n];
        run::Fold& fold = settled[one.name] = {Kind::settled, ranges::count(one.values, 0.) > 0};
        if (one.values.size() == 1) fold.value = one.values[0];
        for (const double value : one.values) fold.gain = std::max(fold.gain, std::abs(value));
        fold.from = std::uint64_t{1} << std::min<std::size_t>(n, 63);
    }
    for (const DeclaredUniform& declared : program.declared)
        if (!program.options.settle) settled[declared.name] = {Kind::settled, true};
    for (const RenamedUniform& renamed : program.renamed)
        if (const auto known = settled.find(renamed.name); known != settled.end())
            settled[renamed.shader_name] = known->second;
    return settled;
}

// Uniforms stay uniforms where nearly the same number gives another picture.
void drop_touchy(Program& program) {
    std::map<std::string_view, run::Fold> passed;
    const std::map<std::string_view, run::Fold> settled = folds(program);
    std::uint64_t touchy = 0;
    for (const Unit& u : program.units) touchy |= run::touchy(u, settled, passed);
    std::size_t n = 0;
    std::erase_if(program.settled, [&](const Settled&) { return (touchy >> std::min<std::size_t>(n++, 63)) & 1; });
}

}  // namespace

void choose_settled(Program& program) {
    if (!program.options.settle) return;
    std::set<std::string> unfit;  // types differ between stages, or the initial value is not known here
    for (const Unit& u : program.units)
        for (const Global& g : u.globals) {
            const bool known = g.init_first < 0 || ranges::count(program.defaults, g.name, &UniformDefault::name) > 0;
            const bool held = g.type.base != Base::dreal || program.target().fp64;
            if (is_uniform(g) && (!g.new_type.empty() || !known || !held)) unfit.insert(scene_name(program, g));
        }
    std::vector<DeclaredUniform> fit;
    for (const DeclaredUniform& declared : program.declared)
        if (declared.simple && !unfit.contains(declared.name)) fit.push_back(declared);
    program.settled = program.options.settle(fit);
    std::erase_if(program.settled, [&](const Settled& settled) {
        if (ranges::find(fit, settled.name, &DeclaredUniform::name) == fit.end()) return true;
        const Global* g = declaration(program, settled.name);
        return !g || constant_text(g->type, settled.values).empty();
    });
    drop_touchy(program);
}

void resolve_marks(Program& program) {
    const bool at_run_time = program.options.undefined_at_run_time;
    const std::map<std::string_view, run::Fold> settled = at_run_time ? folds(program) : decltype(folds(program)){};
    std::map<std::string_view, run::Fold> passed;
    for (Unit& u : program.units) {
        if (!at_run_time && u.marks.empty()) {
            passed.clear();
            continue;
        }
        const std::vector<bool> stay = run::marks_that_stay(u, settled, passed);
        for (Edit& edit : u.edits)
            for (std::size_t at = edit.before.find(mark_name); at != std::string::npos;
                 at = edit.before.find(mark_name, at)) {
                const std::size_t end = edit.before.find('(', at);
                const auto n = static_cast<std::size_t>(std::stoi(edit.before.substr(at + mark_name.size())));
                if (stay[n]) {
                    edit.before.replace(at, end - at, u.marks[n].function);
                    continue;
                }
                edit.before.erase(at, end + 1 - at);
                std::string& after = u.edit(u.marks[n].last).after;
                after.erase(after.find(')'), 1);
            }
        for (std::size_t n = 0; n < stay.size(); ++n)
            if (stay[n] && u.marks[n].call >= 0) u.replace(u.marks[n].call, u.marks[n].function);
        if (ranges::count(stay, true) > 0) provide_marks(u);
    }
}

void settle_uniforms(const Program& program, Unit& u) {
    for (Global& g : u.globals) {
        if (!is_uniform(g) || program.settled.empty()) continue;
        const auto settled = ranges::find(program.settled, scene_name(program, g), &Settled::name);
        if (settled == program.settled.end()) continue;
        // Constants that index an array out of its bounds, or divide by zero, would be errors.
        g.qualifiers.storage = g.type.integral() ? Storage::plain : Storage::constant;
        g.qualifiers.layout.clear();
        g.qualifiers.memory.clear();
        g.qualifiers.interpolation = {};
        g.qualifiers.invariant = g.qualifiers.precise = false;
        g.initial = constant_text(g.type, settled->values);
        g.drop_init = g.dirty = true;
    }
}

}  // namespace snell::glsl
