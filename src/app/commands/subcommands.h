// The subcommands of the program: each adds its options to a CLI11 command, and returns what to run once they are read.
#pragma once

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace snell {
struct Command;
}

namespace snell::app {

using Run = std::function<int()>;  // returns the exit status

Run add_window(CLI::App& command);  // without a subcommand
Run add_new(CLI::App& command);
Run add_render(CLI::App& command);
Run add_sweep(CLI::App& command);
Run add_check(CLI::App& command);
Run add_compare(CLI::App& command);
Run add_grade_command(CLI::App& command);
Run add_explain(CLI::App& command);
Run add_accuracy(CLI::App& command);
Run add_save(CLI::App& command);
Run add_format(CLI::App& command);
Run add_web(CLI::App& command);
Run add_commands(CLI::App& command);
Run add_info(CLI::App& command);
Run add_lsp(CLI::App& command);

// A command of the language as `snell commands NAME` prints it.
std::string described(const Command& row);

}  // namespace snell::app
