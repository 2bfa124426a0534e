// Completions for zsh and fish.
#include "tools/manual/manual.h"

namespace snell::manual {

namespace {

std::string escaped(const std::string& text, std::string_view special, std::string_view before) {
    std::string out;
    for (const char c : text) {
        if (special.find(c) != special.npos) out += before;
        out += c;
    }
    return out;
}

// Within single quotes of zsh.
std::string zsh_text(const std::string& text) {
    std::string out;
    for (const char c : escaped(text, "[]:\\", "\\")) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out;
}

std::string fish_text(const std::string& text) { return "'" + escaped(text, "'\\", "\\") + "'"; }

const char* question(Value value) {
    switch (value) {
        case Value::uniform:
            return "uniforms";
        case Value::rung:
            return "rungs";
        case Value::ladder:
            return "ladders";
        case Value::axis:
            return "axes";
        case Value::name:
            return "help";
        default:
            return nullptr;
    }
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
    return out;
}

// What zsh does for a value: ":message:action".
std::string zsh_action(const Option& option) {
    std::string action = ":" + zsh_text(option.argument) + ":";
    if (const char* kind = question(option.value)) return action + "_snell_ask " + kind;
    switch (option.value) {
        case Value::choice:
            return action + (option.choices.front().ends_with('=')
                                 ? "{compadd -S \"\" - " + joined(option.choices) + "}"
                                 : "(" + joined(option.choices) + ")");
        case Value::file:
            return action + "_files";
        case Value::folder:
            return action + "_files -/";
        case Value::scene:
            return action + "_files -g \"*.glib\"";
        default:
            return action + " ";
    }
}

std::string zsh_specs(const Command& command) {
    std::string out;
    for (const Option& option : command.options)
        for (const auto& names : {option.short_names, option.long_names})
            for (const std::string& name : names) {
                const bool value = option.value != Value::none, is_long = name.starts_with("--");
                out += " \\\n        '" + std::string(option.repeated ? "*" : "") + name +
                       (value ? is_long ? "=" : "+" : "") + "[" + zsh_text(option.doc) + "]" +
                       (value ? zsh_action(option) : "") + "'";
            }
    for (const Option& option : command.positionals) out += " \\\n        '*" + zsh_action(option) + "'";
    return out;
}

std::string fish_value(const Option& option) {
    if (option.value == Value::none) return "";
    if (const char* kind = question(option.value)) return std::string(" -x -a '(__snell_ask ") + kind + ")'";
    switch (option.value) {
        case Value::choice:
            return " -x -a '" + joined(option.choices) + "'";
        case Value::file:
            return " -r -F";
        case Value::folder:
            return " -x -a '(__fish_complete_directories)'";
        case Value::scene:
            return " -k -x -a '(__fish_complete_suffix .glib)'";
        default:
            return " -x";
    }
}

}  // namespace

std::string zsh(const std::vector<Command>& commands) {
    std::string rows, cases, window;
    for (const Command& command : commands) {
        const std::string arguments = "_arguments -s" + zsh_specs(command);
        if (command.name.empty()) {
            window = arguments;
            continue;
        }
        rows += "    '" + command.name + ":" + zsh_text(command.doc) + "'\n";
        cases += "    " + command.name + ")\n      words=(\"${(@)words[2,-1]}\") && (( CURRENT-- ))\n      " +
                 arguments + " ;;\n";
    }
    return "#compdef snell\n# Completion of snell for zsh. Written by snell_manual from the options of the program.\n" +
           std::string(shell_functions("functions.zsh")) +
           "\n_snell() {\n  local curcontext=$curcontext _snell_program=${words[1]} ret=1\n  local -a line "
           "commands=(\n" +
           rows +
           "  )\n  # --color may stand ahead of the subcommand.\n"
           "  while (( CURRENT > 2 )) && [[ ${words[2]} == --color=* ]]; do words[2]=() ; (( CURRENT-- )); done\n"
           "  while (( CURRENT > 3 )) && [[ ${words[2]} == --color ]]; do words[2,3]=() ; (( CURRENT -= 2 )); done\n"
           "  if (( CURRENT == 2 )); then _describe -t commands subcommand commands && ret=0; fi\n"
           "  case ${words[2]-} in\n" +
           cases + "    *)\n      " + window + " && ret=0 ;;\n  esac\n  return ret\n}\n\n_snell \"$@\"\n";
}

std::string fish(const std::vector<Command>& commands) {
    std::string all, rows;
    for (const Command& command : commands)
        if (!command.name.empty()) all += " " + command.name;
    for (const Command& command : commands) {
        const std::string when = command.name.empty() ? "'not __fish_seen_subcommand_from" + all + "'"
                                                      : "'__fish_seen_subcommand_from " + command.name + "'";
        if (!command.name.empty())
            rows +=
                "complete -c snell -n __snell_is_first -f -a " + command.name + " -d " + fish_text(command.doc) + "\n";
        for (const Option& option : command.options) {
            rows += "complete -c snell -n " + when;
            for (const std::string& name : option.short_names) rows += " -s " + name.substr(1);
            for (const std::string& name : option.long_names) rows += " -l " + name.substr(2);
            rows += fish_value(option) + " -d " + fish_text(option.doc) + "\n";
        }
        for (const Option& option : command.positionals)
            rows += "complete -c snell -n " + when + fish_value(option) + "\n";
    }
    return "# Completion of snell for fish. Written by snell_manual from the options of the program.\n\n"
           "# Candidates that only snell knows, for the scene on the line.\nfunction __snell_ask\n"
           "    set -l words (commandline -opc)\n    set -l scene (string match -r '.*\\.glib$' -- $words)[1]\n"
           "    set -l word (string replace -r -- '^--[a-z-]+=' '' (commandline -ct))\n"
           "    command $words[1] complete $argv[1] \"$scene\" \"$word\" 2>/dev/null\nend\n\n"
           "# Whether the subcommand is next: --color may stand ahead of it.\nfunction __snell_is_first\n"
           "    set -l words (commandline -opc)[2..]\n"
           "    while string match -q -- '--color*' $words[1]\n"
           "        if test \"$words[1]\" = --color; set -e words[1]; end\n        set -e words[1]\n    end\n"
           "    test (count $words) -eq 0\nend\n\ncomplete -c snell -f\n" +
           rows;
}

}  // namespace snell::manual
