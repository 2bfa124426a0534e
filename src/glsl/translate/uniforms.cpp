// Uniforms: one type and one initialiser across all stages.
#include <algorithm>
#include <map>

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

}  // namespace snell::glsl
