// The command line: a table of subcommands.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <sstream>
#include <string>

#include "parser/text/utf8.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/version.h"

namespace {

using namespace snell;
using namespace snell::app;

struct Subcommand {
    const char* name;
    const char* summary;
    Run (*add)(CLI::App& command);
};

constexpr Subcommand subcommands[] = {
    {"render", "draw scenes to pictures, without a display", add_render},
    {"sweep", "draw a scene for many values of what can be set", add_sweep},
    {"check", "report errors and warnings", add_check},
    {"explain", "report what a scene costs, and why", add_explain},
    {"accuracy", "measure the error and the cost of each rung", add_accuracy},
    {"save", "write values into a scene: only its numbers change", add_save},
    {"web", "make a page for browsers of a scene, or a gallery of many", add_web},
    {"commands", "list the commands of the language", add_commands},
    {"info", "print the OpenGL version and renderer", add_info},
};

// The process ends on whatever thread this happens, because exceptions would have to pass through drivers and
// libraries. No file is left incomplete: files are written whole or not at all.
void out_of_memory() {
    constexpr std::string_view text =
        "snell: error: out of memory [out-of-memory]\n   help: the scene asks for more than there is; --limit and "
        "--size ask for less\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    _exit(exit_input);
}

// Standard output may be on a full disk.
int printed(int status) {
    const int wrong = std::fflush(stdout) != 0 ? errno : std::ferror(stdout) ? EIO : 0;
    if (wrong == 0) return status;
    fmt::print(stderr, "snell: error: cannot write to standard output: {}\n", std::strerror(wrong));
    return std::max<int>(status, exit_input);
}

// The message may quote arguments, with escape sequences that the terminal would obey.
void print_usage_error(const CLI::App& program, const CLI::ParseError& error) {
    std::ostringstream unused;
    std::stringstream text;
    program.exit(error, unused, text);
    for (std::string line; std::getline(text, line);) fmt::print(stderr, "{}\n", utf8::printable(line));
}

}  // namespace

int main(int argc, char** argv) {
    // Without this, a file that grows beyond its limit would end the process; now writing it fails.
    std::signal(SIGXFSZ, SIG_IGN);
    std::set_new_handler(out_of_memory);
    CLI::App program{"snell runs .glib scenes: GLSL programs with sliders, in a window or to a picture."};
    program.footer(examples);
    program.set_version_flag("--version", std::string("snell ") + version());
    program.require_subcommand(0, 1);
    Run run = add_window(program);
    for (const Subcommand& row : subcommands) {
        CLI::App* command = program.add_subcommand(row.name, row.summary);
        command->final_callback([&run, chosen = row.add(*command)] { run = chosen; });
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version
        print_usage_error(program, error);
        return exit_usage;
    }
    try {
        return printed(run());
    } catch (const std::exception& error) {
        fmt::print(stderr, "snell: error: {}\n", utf8::printable(error.what()));
        return exit_input;
    }
}
