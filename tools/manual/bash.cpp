// Completion for bash, which needs nothing of the package bash-completion.
#include "tools/manual/manual.h"

namespace snell::manual {

namespace {

std::string kind(const Option& option) {
    std::string words;
    switch (option.value) {
        case Value::none:
            return "";
        case Value::text:
            return "none";
        case Value::choice:
            for (const std::string& choice : option.choices) words += (words.empty() ? "" : " ") + choice;
            return words;
        case Value::file:
            return "file";
        case Value::folder:
            return "folder";
        case Value::scene:
            return "scene";
        case Value::uniform:
            return "ask:uniforms";
        case Value::rung:
            return "ask:rungs";
        case Value::ladder:
            return "ask:ladders";
        case Value::axis:
            return "ask:axes";
        case Value::name:
            return "ask:help";
    }
    return "";
}

std::string names(const Option& option, const std::string& before, const std::string& between) {
    std::string out;
    for (const auto& list : {option.short_names, option.long_names})
        for (const std::string& name : list) out += (out.empty() ? "" : between) + before + name;
    return out;
}

}  // namespace

std::string bash(const std::vector<Command>& commands) {
    std::string subcommands, options, takes, arguments;
    for (const Command& command : commands) {
        if (!command.name.empty()) subcommands += (subcommands.empty() ? "" : " ") + command.name;
        std::string words;
        for (const Option& option : command.options) {
            words += (words.empty() ? "" : " ") + names(option, "", " ");
            if (option.value != Value::none)
                takes +=
                    "    " + names(option, "'" + command.name + " ", "' | ") + "') echo '" + kind(option) + "' ;;\n";
        }
        options += "    '" + command.name + "') echo '" + words + "' ;;\n";
        for (const Option& option : command.positionals)
            arguments += "    '" + command.name + "') echo '" + kind(option) + "' ;;\n";
    }
    return "# Completion of snell for bash. Written by snell_manual from the options of the "
           "program.\n\n_snell_commands='" +
           subcommands + "'\n\n# The options of a subcommand, or of the window.\n_snell_options() {\n  case $1 in\n" +
           options +
           "  esac\n}\n\n# What an option takes: words, or the name of a kind.\n_snell_takes() {\n  case \"$1 $2\" "
           "in\n" +
           takes + "  esac\n}\n\n# What a subcommand takes apart from options.\n_snell_argument() {\n  case $1 in\n" +
           arguments + "    *) echo none ;;\n  esac\n}\n" + std::string(shell_functions("functions.bash"));
}

}  // namespace snell::manual
