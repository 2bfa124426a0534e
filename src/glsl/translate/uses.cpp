// Which uniforms of the texts the linked program will have, as far as that is certain without a driver.
#include <algorithm>
#include <array>

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"
#include "src/glsl/run/trial.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

using Use = DeclaredUniform::Use;

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

struct Candidate {
    bool certain = true, named = false, adapted = false;
};

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
    std::vector<Candidate> candidates;
    for (const Unit& u : program.units) {
        const std::set<std::string_view> running = reachable(u);
        for (const Global& g : u.globals) {
            if (g.qualifiers.storage != Storage::uniform || g.name.starts_with("gl_")) continue;
            auto known = ranges::find(declared, g.name, &DeclaredUniform::name);
            if (known == declared.end()) {
                declared.push_back(described(program, u, g));
                candidates.emplace_back();
                known = declared.end() - 1;
            }
            note_functions(u, g, known->functions);
            Candidate& c = candidates[static_cast<std::size_t>(known - declared.begin())];
            c.certain = c.certain && u.code.whole;
            c.named = c.named || named(u, running, g);
            c.adapted = c.adapted || !g.new_type.empty();
        }
        for (const Block& b : u.blocks)
            for (const Member& m : b.members) {
                if (b.qualifiers.storage != Storage::uniform) continue;
                const std::string before = b.instance.empty() ? "" : std::string(b.name) + ".";
                DeclaredUniform d{before + std::string(m.name), std::string(m.type.name)};
                d.array_size = m.type.dims > 0 ? std::max(m.type.size, 0) : 0;
                d.simple = false;
                if (ranges::find(declared, d.name, &DeclaredUniform::name) != declared.end()) continue;
                declared.push_back(std::move(d));
                candidates.push_back({false, true, true});
            }
    }
    std::vector<run::Tried> tried;
    for (std::size_t n = 0; n < declared.size(); ++n) {
        const Candidate& c = candidates[n];
        if (c.certain && !c.named) declared[n].use = Use::none;
        if (c.named && !c.adapted) tried.push_back({declared[n].name, declared[n].simple});
    }
    std::set<std::string_view> matter;
    if (program.options.find_uses) matter = run::that_matter(program.units, tried);
    for (DeclaredUniform& d : declared)
        if (matter.contains(d.name)) d.use = Use::sure;
    for (const RenamedUniform& r : program.renamed)
        for (DeclaredUniform& d : declared)
            if (d.name == r.shader_name) d.name = r.name;
    return declared;
}

}  // namespace snell::glsl
