// The table of commands: one row declares one. The matcher, the documentation, the grammars for editors,
// suggestions and the fuzzer's dictionary derive from it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/signature.h"

namespace snell {

class Builder;
class Arguments;

using Handler = void (*)(Builder&, const Arguments&);

enum class CommandGroup : std::uint8_t { view, transformations, geometry, textures, programs, state, other };

struct Command {
    std::string_view name;
    Signature signature;
    std::string_view doc;  // one or more sentences
    Handler handler;
    std::string_view alias = {};
    bool addition = false;  // snell's, not glman's
    CommandGroup group = CommandGroup::other;

    constexpr bool takes(ArgumentKind kind) const {
        for (const Parameter& p : signature.parameters)
            if (!p.name.empty() && p.kind == kind) return true;
        return false;
    }
};

std::span<const Command> commands();

std::string_view group_name(CommandGroup group);

// By name or alias, without regard to case; nullptr when there is none.
const Command* find_command(std::string_view word);

// Every name and alias, for suggestions.
const std::vector<std::string_view>& command_names();

// The table as JSON: names, aliases, signatures, arguments with kinds and defaults, documentation.
std::string commands_json();

}  // namespace snell
