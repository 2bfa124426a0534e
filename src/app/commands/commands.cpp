// `snell commands`: the commands of the language.
#include "parser/commands/commands.h"

#include <fmt/format.h>

#include "parser/text/diagnostic.h"
#include "parser/text/utf8.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/exit_status.h"
#include "src/content/replace.h"

namespace snell::app {

namespace {

struct CommandsOptions {
    std::string name;  // empty: all
    std::string json;  // a file
};

Exit print_one(const std::string& name) {
    if (const Command* row = find_command(name)) {
        fmt::print("{}\n", described(*row));
        return exit_fine;
    }
    const std::string_view near = nearest(name, command_names());
    fmt::print(stderr, "snell: error: the language has no command '{}'\n   help: {}\n", utf8::printable(name),
               near.empty() ? "'snell commands' lists them" : fmt::format("did you mean '{}'?", near));
    return exit_usage;
}

}  // namespace

std::string described(const Command& row) {
    std::string text = fmt::format("{:<16} {:<48} {}", row.name, row.signature.text, row.doc);
    if (!row.alias.empty()) text += fmt::format("\n{:<16} the same", row.alias);
    return text;
}

Run add_commands(CLI::App& command) {
    auto options = std::make_shared<CommandsOptions>();
    CLI::Option* name = command.add_option("NAME", options->name, "one command");
    add_json(command, options->json, "print all as JSON")->excludes(name);
    return [options] {
        if (!options->name.empty()) return print_one(options->name);
        if (!options->json.empty()) {
            const std::string wrong = content::replace_file(options->json, commands_json() + "\n");
            if (!wrong.empty()) fmt::print(stderr, "snell: error: cannot write '{}': {}\n", options->json, wrong);
            return wrong.empty() ? exit_fine : exit_input;
        }
        for (const Command& row : commands()) fmt::print("{:<16} {:<48} {}\n", row.name, row.signature.text, row.doc);
        return exit_fine;
    };
}

}  // namespace snell::app
