// Uniforms: one type and one initialiser across all stages; those that keep their values become constants, so that the
// driver leaves out what they switch off.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"
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
        const Span first = u.span(it->second->name_token), here = u.span(g.name_token);
        const std::string_view file = program.sources.name(here.file);
        const bool again = first.file != here.file && file == program.sources.name(first.file);
        program.warn(u, g.name_token, "declared-twice",
                     "'" + std::string(g.name) + "' is declared twice: once is enough",
                     again ? included_twice(file) : std::string());
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

std::string scene_name(const Program& program, const Global& g) {
    const auto renamed = ranges::find(program.renamed, g.name, &RenamedUniform::shader_name);
    return renamed == program.renamed.end() ? std::string(g.name) : renamed->name;
}

bool is_uniform(const Global& g) { return g.qualifiers.storage == Storage::uniform && !g.removed; }

// What is known of the unit's uniforms, by the shader's names.
std::map<std::string_view, folding::Fold> folds(const Program& program, const Unit& u) {
    constexpr System finite[] = {System::timer, System::time, System::resolution, System::mouse, System::harmonics};
    static const std::vector<SystemName> names = system_names();
    std::map<std::string_view, folding::Fold> known;
    for (const Global& g : u.globals) {
        if (!is_uniform(g)) continue;
        const auto one = ranges::find(program.settled, scene_name(program, g), &Settled::name);
        if (one == program.settled.end()) {
            const auto provided = ranges::find(names, g.name, &SystemName::name);
            if (provided != names.end() && ranges::count(finite, provided->system) > 0)
                known[g.name] = folding::bounded(1e9, 0);
            continue;
        }
        const std::uint64_t bit = std::uint64_t{1} << std::min<std::ptrdiff_t>(one - program.settled.begin(), 63);
        double most = 0;
        for (const double value : one->values)
            most = std::max(most, std::isfinite(value) ? std::abs(value) : std::numeric_limits<double>::infinity());
        // Of several numbers for a scalar, only how large they are.
        known[g.name] = g.type.scalar() && one->values.size() == 1
                            ? folding::settled_number(g.type.base, one->values[0], bit)
                            : folding::bounded(most, bit);
    }
    return known;
}

// A matrix takes 16 numbers.
std::string mark_call(std::string_view function, std::size_t mark) {
    return std::string(function) + "(" + std::to_string(16 * mark + 1) + ", ";
}

void write_marks(Unit& u, const folding::Decided& decided) {
    const auto call = [&](std::string_view function, std::size_t mark) {
        provide_mark(u, function);
        return mark_call(function, mark);
    };
    const auto function = [&](std::size_t n) -> std::string {
        if (!decided.text[n].empty()) return std::string(decided_text) + decided.text[n] + " : ";
        return call(u.marks[n].kind == Mark::Kind::divisor ? "snell_divisor" : "snell_value", n);
    };
    for (Edit& edit : u.edits)
        for (std::size_t at = edit.before.find(mark_name); at != std::string::npos;
             at = edit.before.find(mark_name, at)) {
            const std::size_t end = edit.before.find('(', at) + 1;
            const auto n = static_cast<std::size_t>(std::stoi(edit.before.substr(at + mark_name.size())));
            edit.before.replace(at, end - at, decided.stay[n] ? function(n) : "");
            if (decided.stay[n]) continue;
            std::string& after = u.edit(u.marks[n].last).after;
            after.erase(after.find(')'), 1);
        }
    // Zeros that the translator gave.
    std::size_t number = u.marks.size();
    const auto keep_zeros = [&](std::string& text) {
        constexpr std::string_view zero = "0.0";
        for (std::size_t at = text.find(zero); at != std::string::npos;) {
            const std::string kept = call("snell_value", number++) + "0.0)";
            text.replace(at, zero.size(), kept);
            at = text.find(zero, at + kept.size());
        }
    };
    for (std::size_t n = 0; n < u.marks.size(); ++n)
        if (decided.stay[n] && u.marks[n].step < 0) keep_zeros(u.edit(u.marks[n].last).after);
    if (decided.possible) keep_zeros(u.main_start);
}

}  // namespace

void choose_settled(Program& program) {
    if (!program.options.settle) return;
    std::set<std::string> unfit;  // types differ between stages, or the initial value is not known here
    for (const Unit& u : program.units)
        for (const Global& g : u.globals) {
            const bool known = g.init_first < 0 || ranges::count(program.defaults, g.name, &UniformDefault::name) > 0;
            if (is_uniform(g) && (!g.new_type.empty() || !known)) unfit.insert(scene_name(program, g));
        }
    std::vector<DeclaredUniform> fit;
    for (const DeclaredUniform& declared : program.declared)
        if (declared.simple && !unfit.contains(declared.name)) fit.push_back(declared);
    program.settled = program.options.settle(fit);
    std::erase_if(program.settled, [&](const Settled& settled) {
        return ranges::find(fit, settled.name, &DeclaredUniform::name) == fit.end();
    });
}

void write_constant(Program& program) {
    const std::optional<Settled>& constant = program.options.constant;
    if (!constant || constant->values.size() != 1) return;
    for (Unit& u : program.units)
        for (Global& g : u.globals) {
            if (!is_uniform(g) || scene_name(program, g) != constant->name) continue;
            const std::string text = folding::number_text(g.type.base, constant->values[0]);
            if (text.empty() || !g.type.scalar() || !g.new_type.empty()) return program.settled.clear();
            // Constants that index an array out of its bounds, or divide by zero, would be errors.
            g.qualifiers.storage = g.type.integral() ? Storage::plain : Storage::constant;
            g.qualifiers.layout.clear();
            g.qualifiers.memory.clear();
            g.qualifiers.interpolation = {};
            g.qualifiers.invariant = g.qualifiers.precise = false;
            g.initial = text;
            g.drop_init = g.dirty = true;
            program.settled = {*constant};
        }
}

void resolve_marks(Program& program) {
    std::map<std::string_view, folding::Fold> passed;
    std::uint64_t from = 0, signs = 0;
    for (const Unit& u : program.units)
        if (!program.settled.empty()) signs |= folding::signs(u, folds(program, u), passed);
    passed.clear();
    for (Unit& u : program.units) {
        if (!program.options.settle && u.marks.empty()) {
            passed.clear();
            continue;
        }
        std::map<std::string_view, folding::Fold> free;
        for (const Global& g : u.globals)
            if (is_uniform(g) && g.type.scalar() && program.options.settle)
                free[g.name] = folding::free_number(g.type.base);
        const folding::Decided decided = folding::decide(u, folds(program, u), free, signs, passed);
        write_marks(u, decided);
        from |= decided.from;
    }
    std::size_t n = 0;
    std::erase_if(program.settled, [&](const Settled&) { return !(from >> std::min<std::size_t>(n++, 63) & 1); });
}

// Which uniforms the texts declare, and which of them code that runs names.

namespace {

// Functions that main may call, by their names.
std::set<std::string_view> reachable(const Unit& u) {
    std::set<std::string_view> found = {"main"};
    std::vector<std::string_view> open = {"main"};
    while (!open.empty()) {
        const std::string_view name = open.back();
        open.pop_back();
        for (const Function& f : u.functions) {
            if (f.name != name || f.code < 0) continue;
            for (int k = f.code; k < f.code_end; ++k) {
                const Instruction& i = u.code.steps[static_cast<std::size_t>(k)];
                if (i.op == Op::call && found.insert(i.text).second) open.push_back(i.text);
            }
        }
    }
    return found;
}

// Whether code that runs names the variable.
bool named(const Unit& u, const std::set<std::string_view>& running, const Global& g) {
    return ranges::any_of(g.uses, [&](int token) {
        const auto around =
            ranges::find_if(u.functions, [&](const Function& f) { return f.open < token && token < f.close; });
        return around == u.functions.end() || running.contains(around->name);
    });
}

void note_functions(const Unit& u, const Global& g, std::vector<std::string>& functions) {
    constexpr std::array<std::string_view, 5> stages{"vertex", "tessellation control", "tessellation evaluation",
                                                     "geometry", "fragment"};  // as Stage
    for (const Function& function : u.functions) {
        const auto within = [&](int use) { return use > function.open && use < function.close; };
        if (!ranges::any_of(g.uses, within)) continue;
        std::string name(function.name);
        name.append(" (").append(stages[static_cast<std::size_t>(u.stage)]).append(")");
        if (ranges::count(functions, name) == 0) functions.push_back(std::move(name));  // overloaded
    }
}

DeclaredUniform described(const Program& program, const Unit& u, const Global& g) {
    DeclaredUniform d;
    if (g.name_token >= 0) d.span = u.span(g.name_token);
    d.name = g.name;
    const std::string_view own = g.type.basic() ? type_name(g.type.base, g.type.rows, g.type.cols) : g.type.name;
    d.glsl_type = g.new_type.empty() ? own : g.new_type;
    d.array_size = g.type.dims > 0 ? std::max(g.type.size, 0) : 0;
    d.simple = g.type.dims == 0 && g.type.basic();
    const auto initial = ranges::find(program.defaults, g.name, &UniformDefault::name);
    if (initial != program.defaults.end()) d.initial = initial->values;
    return d;
}

}  // namespace

std::vector<DeclaredUniform> declared_uniforms(Program& program) {
    std::vector<DeclaredUniform> declared;
    for (const Unit& u : program.units) {
        const std::set<std::string_view> running = reachable(u);
        for (const Global& g : u.globals) {
            if (g.qualifiers.storage != Storage::uniform || g.name.starts_with("gl_")) continue;
            auto known = ranges::find(declared, g.name, &DeclaredUniform::name);
            if (known == declared.end()) {
                declared.push_back(described(program, u, g));
                known = declared.end() - 1;
            }
            note_functions(u, g, known->functions);
            known->used = known->used || !u.code.whole || named(u, running, g);
        }
        for (const Block& b : u.blocks)
            for (const Member& m : b.members) {
                if (b.qualifiers.storage != Storage::uniform) continue;
                const std::string before = b.instance.empty() ? "" : std::string(b.name) + ".";
                DeclaredUniform d{before + std::string(m.name), std::string(m.type.name)};
                d.array_size = m.type.dims > 0 ? std::max(m.type.size, 0) : 0;
                d.simple = false;
                d.in_block = d.used = true;
                if (ranges::find(declared, d.name, &DeclaredUniform::name) != declared.end()) continue;
                declared.push_back(std::move(d));
            }
    }
    for (const RenamedUniform& r : program.renamed)
        for (DeclaredUniform& d : declared)
            if (d.name == r.shader_name) d.name = r.name;
    return declared;
}

}  // namespace snell::glsl
