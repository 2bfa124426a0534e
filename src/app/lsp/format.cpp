// `snell format`: lays out the text of scenes.
#include "src/app/open/complain.h"
#include "src/language/services.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "parser/text/words.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/write_copy.h"
#include "src/content/files.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

constexpr std::string_view standard_input = "-";

struct FormatOptions {
    std::vector<std::string> files;
    bool check = false;
};

std::optional<std::string> read_standard_input(std::string& error) {
    const std::uint64_t limit = Limits{}.text_bytes;
    std::string text;
    std::array<char, 1 << 16> buffer{};
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
        text.append(buffer.data(), count);
        if (text.size() > limit) {
            error = fmt::format("it is larger than {} bytes", limit);
            return std::nullopt;
        }
    }
    if (std::ferror(stdin) == 0) return text;
    error = std::strerror(errno);
    return std::nullopt;
}

// Why the text is not formatted: it is not that of a scene.
std::string unfit(const std::string& path, std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "the text is UTF-16: save it as UTF-8";
    return is_shader_name(path) ? "it is a shader; 'snell format' formats scenes" : "";
}

// Returns the exit status for this file.
Exit format_one(const std::string& path, bool check) {
    const bool piped = path == standard_input;
    const auto refuse = [&](const std::string& what) {
        return complain(exit_input, fmt::format("{}: {}", piped ? "standard input" : path, what));
    };
    std::string error;
    const auto text =
        piped ? read_standard_input(error) : content::read_regular_file(path, Limits{}.text_bytes, {}, error);
    if (!text) return refuse(error);
    if (error = unfit(path, *text); !error.empty()) return refuse(error);
    const std::string now = language::formatted(*text);
    if (check) {
        if (now == *text) return exit_fine;
        fmt::print("{}\n", utf8::printable(path));
        return exit_input;
    }
    if (piped) {
        std::fwrite(now.data(), 1, now.size(), stdout);
        return exit_fine;
    }
    if (now == *text) return exit_fine;
    error = write_saved({{path, *text, now}});
    if (error.starts_with(path + ": ")) error.erase(0, path.size() + 2);
    return error.empty() ? exit_fine : refuse(error);
}

}  // namespace

Run add_format(CLI::App& command) {
    auto options = std::make_shared<FormatOptions>();
    command
        .add_option("SCENE", options->files,
                    "scenes, whose files are replaced; '-': from standard input to standard output")
        ->required();
    command.add_flag("--check", options->check,
                     "replace nothing; list files that would change, and end with status 1 if there are any");
    command.footer(
        "Statements between PushMatrix and PopMatrix, glBegin and glEnd, and in passes to textures are indented,\n"
        "and continued lines are aligned. Nothing else changes. Scenes are not judged: 'snell check' does that.");
    return [options] {
        Exit status = exit_fine;
        for (const std::string& path : options->files)
            if (format_one(path, options->check) != exit_fine) status = exit_input;
        return status;
    };
}

}  // namespace snell::app
