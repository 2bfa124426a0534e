#include "src/app/help/program.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/version.h"

namespace snell::app {

namespace {

constexpr const char* program_examples = R"(Examples, in a folder with scenes/ of snell:
  snell scenes/light/glass/glass.glib                        # open a scene in a window
  snell render scenes/light/glass/glass.glib -o glass.png    # draw a picture, without a display
  snell check scenes/light/glass/glass.glib                  # report errors and warnings
  snell help render                                          # explain a subcommand, with examples
  snell help unknown-command                                 # explain the code of a message
  snell commands Sphere                                      # explain a command of the language

Exit status: 0 fine, 1 errors in the input, 2 wrong usage, 3 no graphics,
4 timeout, 5 the graphics driver reset itself.)";

constexpr auto table = std::to_array<Subcommand>({
    {"new", "make a folder with a scene to start from", add_new,
     "  snell new glass                                            # a ball of glass: the name says so\n"
     "  snell new out/homework-1 --kind displace"},
    {"render", "draw scenes to pictures, without a display", add_render,
     "  snell render scenes/light/glass/glass.glib -o glass.png --set uIndex=1.33 --ladder BEND=single\n"
     "  snell render scenes/light/glass/glass.glib -o glass.exr --size 1920x1080 --time 2.5 --samples 4\n"
     "  snell render scenes/light/carousel/carousel.glib -o 'out/{frame:04}.png' --frames 100 --fps 25\n"
     "  snell render scenes/light/*/*.glib -o 'out/{stem}.png'     # many scenes"},
    {"sweep", "draw a scene for many values of what can be set", add_sweep,
     "  snell sweep scenes/light/glass/glass.glib --over uIndex=1:2.5:16 -o 'glass-{uIndex}.png' --sheet all.png"},
    {"check", "report errors and warnings", add_check,
     "  snell check scenes/light/glass/glass.glib\n"
     "  snell check scenes/light/*/*.glib --json --confine scenes  # for scripts that grade homework"},
    {"compare", "measure how far pictures or scenes are from each other", add_compare,
     "  snell compare scenes/light/glass/glass.glib scenes/light/glass/glass.glib --max-rmse 0.01"},
    {"grade", "grade submissions by a rubric, and make a page for each", add_grade_command,
     "  snell grade --new scenes/light/glass/glass.glib            # print a rubric to start from"},
    {"explain", "report what a scene costs, and why", add_explain,
     "  snell explain scenes/light/glass/glass.glib --size 800x600\n"
     "  snell explain scenes/light/ambient/ambient.glib --no-time  # also what its values switch off"},
    {"accuracy", "measure the error and the cost of each rung", add_accuracy,
     "  snell accuracy scenes/light/glass/glass.glib -o report.html --ladders all\n"
     "  snell accuracy scenes/light/mirror/mirror.glib --within 16ms   # the most exact rungs for 16 ms"},
    {"save", "write values into a scene: only its numbers change", add_save,
     "  snell save scenes/light/glass/glass.glib --set uIndex=1.33\n"
     "  snell save scenes/light/glass/glass.glib --set uIndex=1.33 -o scenes/light/glass/water.glib"},
    {"format", "indent scenes and align continued lines", add_format,
     "  snell format scenes/light/glass/glass.glib\n"
     "  snell format --check scenes/light/*/*.glib                 # list those that would change\n"
     "  snell format - <scenes/light/glass/glass.glib              # print the formatted text"},
    {"web", "make a page for browsers of a scene, or a gallery of many", add_web,
     "  snell web scenes/light/glass/glass.glib -o out/glass.html --set uIndex=1.33\n"
     "  snell web --gallery scenes/light -o out/gallery            # a page of each, and an index"},
    {"commands", "list the commands of the language", add_commands,
     "  snell commands                                             # all commands\n"
     "  snell commands Sphere                                      # one command\n"
     "  snell commands --json"},
    {"info", "print the OpenGL version and renderer", add_info,
     "  snell info\n"
     "  snell info --context es3.0                                 # of another version"},
    {"lsp", "run the language server, which editors start", add_lsp,
     "  snell lsp </dev/null                                       # without an editor it ends with status 1"},
    {"help", "explain a subcommand, a command of the language or the code of a message", add_help,
     "  snell help render\n"
     "  snell help pow-of-negative                                 # the code at the end of a message\n"
     "  snell help Sphere"},
    {"complete", "print what may follow on a command line, for shells", add_complete,
     "  snell complete uniforms scenes/light/glass/glass.glib uI\n"
     "  snell complete rungs scenes/light/glass/glass.glib",
     true},
});

// What stands for the value of an option in --help. Completions (tools/manual) go by these names.
struct ValueName {
    std::string_view option;
    const char* value;
};
constexpr auto value_names = std::to_array<ValueName>({
    {"allow", "FOLDER"},       {"apply", "NUMBERS"},    {"budget", "SECONDS"},     {"color", "WHEN"},
    {"confine", "FOLDER"},     {"context", "VERSION"},  {"csv", "FILE"},           {"dump", "STAGE"},
    {"error", "RMSE"},         {"fps", "RATE"},         {"frames", "COUNT"},       {"from", "RUNGS"},
    {"jobs", "COUNT"},         {"json", "FILE"},        {"kind", "KIND"},          {"knobs", "KNOB,…"},
    {"ladder", "LADDER=RUNG"}, {"ladders", "LADDER,…"}, {"limit", "LIMIT=VALUE"},  {"link", "URL"},
    {"markdown", "FILE"},      {"max-flip", "FLIP"},    {"max-pixels", "PERCENT"}, {"memory", "GIGABYTES"},
    {"max-rmse", "RMSE"},      {"merge", "FILE"},       {"output", "FILE"},        {"over", "NAME=VALUES"},
    {"quality", "PRESET"},     {"reps", "COUNT"},       {"samples", "COUNT"},      {"set", "UNIFORM=VALUE"},
    {"shard", "I/N"},          {"sheet", "FILE"},       {"size", "WIDTHxHEIGHT"},  {"slide", "FILE"},
    {"stats", "FILE"},         {"steps", "COUNT"},      {"svg", "FILE"},           {"threshold", "VALUE"},
    {"tile", "PIXELS"},        {"time", "SECONDS"},     {"timeout", "SECONDS"},    {"title", "TEXT"},
    {"view", "VIEW"},          {"within", "TIME"},
});

// Flags have no type.
void name_values(CLI::App& command) {
    for (CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            option->type_name("");
            if (option->get_description().empty()) option->description("the scene");
        }
        // Compared as views, and types last, because this runs at every start.
        if (option->get_lnames().empty()) continue;
        const std::string_view name = option->get_lnames().front();
        const auto row = ranges::find_if(value_names, [&](const ValueName& v) { return v.option == name; });
        if (row != value_names.end() && !option->get_type_name().empty()) option->type_name(row->value);
    }
}

void add_color(CLI::App& command, std::string& color) {
    command.add_option("--color", color, "colours in messages; auto: on a terminal")
        ->check(CLI::IsMember({"auto", "always", "never"}));
}

// Options cost time at every start, and only those of the subcommand that runs, or is explained, matter.
bool matters(const Subcommand& row, std::string_view first) {
    if (first == row.name || first == "help") return true;
    return first != "--version" && ranges::find(table, first, &Subcommand::name) == table.end();
}

// `--json` of these has always taken the next word.
bool json_is_file(std::string_view subcommand) {
    return subcommand == "render" || subcommand == "sweep" || subcommand == "accuracy";
}

bool names_json(std::string_view word, std::string_view subcommand) {
    if (word.empty() || word.ends_with(".glib")) return false;
    if (word == "-" || word.ends_with(".json") || word.starts_with("/dev/") || word.starts_with("/proc/")) return true;
    return json_is_file(subcommand) && !word.starts_with('-');
}

bool names_output(std::string_view option) {
    constexpr auto outputs = std::to_array<std::string_view>(
        {"-o", "--output", "--sheet", "--stats", "--csv", "--markdown", "--svg", "--sarif"});
    return ranges::find(outputs, option) != outputs.end();
}

}  // namespace

std::span<const Subcommand> subcommands() { return table; }

std::vector<std::string_view> subcommand_names() {
    std::vector<std::string_view> names;
    for (const Subcommand& row : table)
        if (!row.hidden) names.emplace_back(row.name);
    return names;
}

std::string_view first_word(int count, const char* const* words) {
    int at = 1;
    while (at < count && std::string_view(words[at]).starts_with("--color"))
        at += std::string_view(words[at]) == "--color" ? 2 : 1;
    return at < count ? words[at] : std::string_view();
}

std::optional<Misspelt> misspelt_option(CLI::App& program, std::string_view first, int count,
                                        const char* const* words) {
    const auto commands = program.get_subcommands([&](CLI::App* command) { return command->get_name() == first; });
    std::vector<std::string> known = {"--help"};
    for (const CLI::Option* option : (commands.empty() ? &program : commands.front())->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    const std::vector<std::string_view> names(known.begin(), known.end());
    for (int at = 1; at < count; ++at) {
        const std::string_view word = words[at], name = word.substr(0, word.find('='));
        if (word == "--") break;
        if (!word.starts_with("--") || ranges::find(names, name) != names.end()) continue;
        if (const std::string_view meant = nearest(name, names); !meant.empty())
            return Misspelt{std::string(name), std::string(meant)};
    }
    return std::nullopt;
}

std::vector<std::string> meant_words(int count, const char* const* words) {
    constexpr const char* standard_output = "/dev/stdout";
    std::vector<std::string> meant(words, words + count);
    const std::string_view subcommand = first_word(count, words);
    for (std::size_t i = 1; i < meant.size(); ++i) {
        std::string& word = meant[i];
        const std::string next = i + 1 < meant.size() ? meant[i + 1] : "";
        if (word == "--") break;
        if (word == "--json" && names_json(next, subcommand)) {
            word += "=" + (next == "-" ? std::string(standard_output) : next);
            meant.erase(meant.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        } else if (word == "--json" && json_is_file(subcommand) && (i + 1 == meant.size() || next.starts_with('-'))) {
            word += std::string("=") + standard_output;
        } else if (names_output(word) && next == "-") {
            meant[++i] = standard_output;
        } else if (word.starts_with("--") && word.ends_with("=-") &&
                   (word == "--json=-" || names_output(std::string_view(word).substr(0, word.size() - 2)))) {
            word.replace(word.size() - 1, 1, standard_output);
        }
    }
    return meant;
}

void describe(CLI::App& program, Request& request, std::string_view first) {
    program.description("snell runs .glib scenes: GLSL programs with sliders, in a window or to a picture.");
    program.name("snell");
    program.set_version_flag("--version", std::string("snell ") + version());
    program.require_subcommand(0, 1);
    request.run = add_window(program);
    add_color(program, request.color);
    name_values(program);
    for (const Subcommand& row : table) {
        CLI::App* command = program.add_subcommand(row.name, row.summary);
        if (row.hidden) command->group("");
        if (!matters(row, first)) continue;
        add_color(*command, request.color);
        command->final_callback([&request, chosen = row.add(*command)] { request.run = chosen; });
        name_values(*command);
        const std::string notes = command->get_footer();
        command->footer(notes + (notes.empty() ? "" : "\n\n") + "Examples, in a folder with scenes/ of snell:\n" +
                        row.examples);
    }
    program.footer(program_examples);  // not before, because subcommands inherit it
}

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
