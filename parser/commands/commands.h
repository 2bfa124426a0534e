// The table of commands, with one row for each. The matcher, the documentation, the editors' grammars, suggestions and
// the fuzzer's dictionary are derived from it.
// Commands of OpenGL and its helpers that the language lacks, and what does their work in a scene.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/commands/signature.h"

namespace snell {

class Builder;
class Arguments;

using Handler = void (*)(Builder&, const Arguments&);

struct Command {
    std::string_view name;
    Signature signature;
    std::string_view doc;  // one or more sentences
    Handler handler;
    std::string_view alias = {};
    bool addition = false;        // not a command of glman
    std::string_view group = {};  // heading in docs/language.md

    constexpr bool takes(ArgumentKind kind) const {
        for (const Parameter& p : signature.parameters)
            if (!p.name.empty() && p.kind == kind) return true;
        return false;
    }
};

std::span<const Command> commands();

// Finds a command by name or alias, without regard to case; returns nullptr if there is none.
const Command* find_command(std::string_view word);

// Every name and alias, for suggestions.
const std::vector<std::string_view>& command_names();

// Returns the table as JSON: names, aliases, signatures, arguments with kinds and defaults, documentation.
std::string commands_json();

// What to write for a statement of OpenGL ("glEnable GL_BLEND", "ShadeModel GL_FLAT"), or why there is nothing to
// write; empty for other words.
std::string help_for_opengl(std::string_view word, std::string_view argument);

}  // namespace snell
