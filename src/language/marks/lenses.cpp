// What can be done with a scene, offered above its statements.
#include "src/language/marks/statement_kinds.h"
#include "src/language/names/texts.h"
#include "src/language/services.h"

namespace snell::language {

std::vector<CodeLens> code_lenses(const Project& project, FileId file) {
    Texts texts(project);
    std::vector<CodeLens> found;
    if (!texts.is_scene(file)) return found;
    const Statements& s = texts.statements(file);
    const Span start = s.items.empty() ? Span{file, 0, 0} : s.span(s.items.front());
    found.push_back({CodeLens::Kind::open, start, {}});
    found.push_back({CodeLens::Kind::render, start, {}});
    for (const SceneStatement& statement : s.items) {
        if (statement.command == nullptr) continue;
        const Command& command = *statement.command;
        const bool named = command.name == "Program" && statement.count > 1;
        const bool computes = command.name == "Irradiance" || command.name == "Prefilter";
        if (!named && !computes && !begins_pass(command)) continue;
        found.push_back({CodeLens::Kind::cost, s.span(statement),
                         std::string(named ? s.word(s.tokens[statement.first + 1]) : command.name)});
    }
    return found;
}

}  // namespace snell::language
