// Mistakes whose meaning is clear, and which some compilers accept.
#include <algorithm>

#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

// Prototypes within a function move ahead of it. They follow it in the list.
static void lift_prototypes(Unit& u) {
    std::string lifted;
    int around = -1;
    const auto put = [&] {
        if (around >= 0 && !lifted.empty()) u.edit(around).before.insert(0, lifted);
        lifted.clear();
    };
    for (const Function& f : u.functions) {
        if (f.open >= 0) {
            put();
            around = f.first;
        } else if (f.local) {
            lifted += render(u, f.first, f.parameters_end) + "; ";
            u.erase(f.first, f.parameters_end + 1);
        }
    }
    put();
}

// In old versions, functions and variables had separate namespaces.
void separate_functions(Unit& u) {
    for (int i = 0; i + 1 < static_cast<int>(u.tokens.size()); ++i) {
        const std::string_view t = u.at(i).text;
        if (u.at(i).kind != Kind::identifier || u.at(i + 1).text != "(" || !u.shared_by_kinds.contains(t)) continue;
        if (u.now(i) == t && (i == 0 || u.at(i - 1).text != ".")) u.replace(i, "snell_" + std::string(t));
    }
}

// Functions called above their definition get a prototype.
void declare_functions(Program& program, Unit& u) {
    lift_prototypes(u);
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
        if (!g.type.basic()) continue;
        const std::string name(u.now(g.name_token)), copy = "snell_copy_" + name;
        program.warn(u, g.name_token, "assigned-input",
                     "'" + name + "' comes from outside and cannot be assigned: a copy is");
        u.header += std::string(g.type.name) + " " + copy + ";\n";
        for (const int token : g.uses) u.replace(token, copy);
        at_main_start(u, copy + " = " + name + ";");
    }
}

}  // namespace snell::glsl
