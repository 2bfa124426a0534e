// `snell commands`: the commands of the language.
#include "parser/commands/commands.h"

#include <fmt/format.h>

#include "parser/text/diagnostic.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/exit_status.h"

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
    return complain(exit_usage, fmt::format("the language has no command '{}'", name),
                    near.empty() ? "'snell commands' lists them" : fmt::format("did you mean '{}'?", near));
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
        if (!options->json.empty()) return write_output(options->json, commands_json() + "\n") ? exit_fine : exit_input;
        for (const Command& row : commands()) fmt::print("{:<16} {:<48} {}\n", row.name, row.signature.text, row.doc);
        return exit_fine;
    };
}

}  // namespace snell::app
