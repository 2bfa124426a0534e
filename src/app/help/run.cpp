#include "src/app/help/run.h"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>

#include "parser/text/words.h"
#include "src/app/help/help.h"
#include "src/app/help/program.h"
#include "src/app/open/color.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"

namespace snell::app {

namespace {

// Images and meshes come and go by the megabyte; memory that goes back to the system and returns is cleared page by
// page each time, which costs more than decoding does.
void keep_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
    mallopt(M_TRIM_THRESHOLD, 64 << 20);
}

// Standard output may be on a full disk. One that is painted holds a line back until its end, which the last may lack.
int printed(int status, bool painted) {
    const bool failed = std::ferror(stdout) != 0;
    const int wrong = (painted ? std::fclose(stdout) : std::fflush(stdout)) != 0 ? errno : failed ? EIO : 0;
    if (wrong == 0) return status;
    complain(fmt::format("cannot write to standard output: {}", std::strerror(wrong)));
    return std::max<int>(status, exit_input);
}

// The message may quote arguments, with escape sequences that the terminal would obey.
void print_usage_error(const CLI::App& program, const CLI::ParseError& error) {
    std::ostringstream unused;
    std::stringstream text;
    program.exit(error, unused, text);
    for (std::string line; std::getline(text, line);) fmt::print(stderr, "{}\n", utf8::printable(line));
}

// Returns whether standard output is painted.
bool choose_colors(const std::string& when) {
    if (wants_color(when, isatty(STDERR_FILENO) != 0)) paint(stderr);
    const bool painted = wants_color(when, isatty(STDOUT_FILENO) != 0);
    if (painted) paint(stdout);
    return painted;
}

}  // namespace

int run(int argc, const char* const* argv) {
    // Without this, a file that grows beyond its limit would end the process; now writing it fails.
    std::signal(SIGXFSZ, SIG_IGN);
    watch_memory();
    keep_freed_memory();
    CLI::App program;
    Request request;
    const std::string_view first = first_word(argc, argv);
    describe(program, request, first);
    if (const std::string_view meant = meant_subcommand(first); !meant.empty()) {
        choose_colors(request.color);
        return complain(exit_usage, fmt::format("there is neither a subcommand nor a file '{}'", first),
                        fmt::format("did you mean '{}'?", meant));
    }
    std::vector<std::string> words = meant_words(argc, argv);
    try {
        if (!words.empty()) words.erase(words.begin());
        std::reverse(words.begin(), words.end());  // CLI11 takes the last one first
        program.parse(std::move(words));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) return printed(program.exit(error), false);  // --help, --version
        if (const auto misspelt = misspelt_option(program, first, argc, argv)) {
            return complain(exit_usage, fmt::format("there is no option '{}'", misspelt->word),
                            fmt::format("did you mean '{}'?", misspelt->meant));
        }
        print_usage_error(program, error);
        return exit_usage;
    }
    const bool painted = choose_colors(request.color);
    return status_of([&] { return printed(request.run(), painted); });
}

}  // namespace snell::app
