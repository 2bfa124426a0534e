// `snell commands`: the commands of the language.
#include <fmt/format.h>

#include "parser/commands/commands.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/exit_status.h"

namespace snell::app {

Run add_commands(CLI::App& command) {
    auto json = std::make_shared<bool>(false);
    command.add_flag("--json", *json, "print JSON");
    return [json] {
        if (*json) {
            fmt::print("{}\n", commands_json());
            return exit_fine;
        }
        for (const Command& row : commands()) fmt::print("{:<16} {:<48} {}\n", row.name, row.signature.text, row.doc);
        return exit_fine;
    };
}

}  // namespace snell::app
