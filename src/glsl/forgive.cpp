// Slips that a forgiving compiler reads past and whose meaning is clear.
#include <algorithm>

#include "src/glsl/program.h"
#include "src/glsl/words.h"

namespace snell::glsl {

// Functions called above their definition get a prototype.
void declare_functions(Program& program, Unit& u) {
    std::string prototypes;
    const Function* first = nullptr;
    for (const Function& f : u.functions) {
        if (f.open < 0) continue;
        if (!first) first = &f;
        const auto call = u.unknown_calls.find(f.name);
        if (call == u.unknown_calls.end() || call->second > f.name_token || f.name == "main") continue;
        program.warn(u, call->second, "used-before-definition",
                     "'" + std::string(f.name) + "' is called before it is declared");
        prototypes += render(u, f.first, f.parameters_end) + "; ";
    }
    if (first && !prototypes.empty()) {
        Edit& e = u.edit(first->first);
        e.before = prototypes + e.before;
    }
}

// Inputs and uniforms can't be assigned: the assignments go to a copy.
void copy_assigned(Program& program, Unit& u) {
    for (const Global& g : u.globals) {
        const Storage s = g.qualifiers.storage;
        const bool constant = s == Storage::in || s == Storage::uniform;
        if (!constant || !g.written || g.removed || g.type.dims || !g.new_type.empty() || g.name.starts_with("gl_"))
            continue;
        if (g.type.base < Base::boolean || g.type.base > Base::dreal) continue;
        const std::string name(u.now(g.name_token)), copy = "snell_copy_" + name;
        program.warn(u, g.name_token, "assigned-input",
                     "'" + name + "' comes from outside and can't be assigned: a copy is");
        u.header += std::string(g.type.name) + " " + copy + ";\n";
        for (const int token : g.uses) u.replace(token, copy);
        at_main_start(u, copy + " = " + name + ";");
    }
}

}  // namespace snell::glsl
