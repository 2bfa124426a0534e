#include "src/app/commands/advice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "src/app/commands/options.h"
#include "src/app/open/command_text.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/write_copy.h"
#include "src/app/picture/outputs.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"
#include "src/document/document.h"
#include "src/plan/texts.h"

namespace snell::app {

namespace {

using namespace snell::accuracy;

// A scene that was read, and what can be changed in it.
struct Found {
    Found(const std::string& path, const Access& access) : files(scene_folder(path), access) {}

    Files files;
    Sources sources;
    Plan plan;
    std::vector<Change> changes;
    bool errors = false;  // in the scene; they are printed
};

void print_errors(const Diagnostics& all, const Sources& sources) {
    fmt::print(stderr, "{}", snell::render(errors_of(all), sources));
}

// Only a driver knows all errors of shaders. Without one, nothing is said of them.
bool print_shader_errors(const std::string& path, const Access& access) {
    std::string unheard;
    const auto context = HeadlessContext::make({}, unheard);
    if (!context) return false;
    const auto document = open_document(path, gl::query_caps(), nullptr, nullptr, {}, access);
    print_errors(document->diagnostics, document->sources);
    return document->diagnostics.has_errors();
}

// Returns null after it printed why the scene cannot be read.
std::unique_ptr<Found> find_in(const std::string& path, const AccuracyOptions& options) {
    auto found = std::make_unique<Found>(path, options.access);
    Diagnostics diagnostics(options.access.limits);
    bool chosen = true;
    auto plan = read_plan(path, found->files, found->sources, diagnostics);
    if (plan) {
        found->plan = std::move(*plan);
        for (const std::string& choice : options.choices)
            chosen = choose_rung(found->plan.rungs, found->plan.scene, choice, diagnostics) && chosen;
        found->changes = find_changes(found->plan, found->files, found->sources);
    }
    print_errors(diagnostics, found->sources);
    if (!plan || !chosen) return nullptr;
    found->errors = diagnostics.has_errors() || print_shader_errors(path, options.access);
    return found;
}

std::string list_text(const Found& found) {
    if (found.changes.empty()) return "snell finds nothing to change in this scene\n";
    std::string text;
    for (std::size_t i = 0; i < found.changes.size(); ++i)
        text += fmt::format("{:>4}  {:<20} {}\n", i + 1, facts(found.changes[i].kind).name,
                            change_line(found.changes[i], found.sources));
    return text;
}

std::string list_json(const std::string& scene, const Found& found) {
    nlohmann::ordered_json json{{"schema", 1}, {"scene", scene}, {"found", nlohmann::ordered_json::array()}};
    for (std::size_t i = 0; i < found.changes.size(); ++i) {
        const Change& change = found.changes[i];
        const Position at = found.sources.position(change.where.file, change.where.begin);
        const KindFacts& kind = facts(change.kind);
        json["found"].push_back({{"number", i + 1},
                                 {"kind", kind.name},
                                 {"aim", name(kind.aim)},
                                 {"file", found.sources.name(change.where.file)},
                                 {"line", at.line},
                                 {"column", at.column},
                                 {"before", change.before},
                                 {"after", change.after}});
        if (const auto more = other_edits(change, found.sources); !more.empty()) json["found"].back()["more"] = more;
    }
    return content::json_text(json) + "\n";
}

Exit list_found(const AccuracyOptions& options, const Found& found) {
    fmt::print("{}", list_text(found));
    if (options.json.empty()) return exit_fine;
    const std::vector<std::string> read = used_files(found.plan, found.sources, found.files);
    const Exit wrong = check_outputs(std::vector{options.json}, read);
    if (wrong != exit_fine) return wrong;
    return write_output(options.json, list_json(options.scenes.front(), found)) ? exit_fine : exit_input;
}

// Draws the expressions whose means are needed for the rung. False if there is no OpenGL to draw them with.
bool fill(Found& found, const AccuracyOptions& options) {
    std::vector<Change*> unfilled;
    std::string unheard;  // choose_changes() says what is wrong
    for (const std::size_t index :
         parse_rung(options.apply, found.changes, unheard).value_or(std::vector<std::size_t>{}))
        if (!found.changes[index].probes.empty()) unfilled.push_back(&found.changes[index]);
    if (unfilled.empty()) return true;
    const auto context = headless_context(options.context);
    if (context)
        fill_averages({options.scenes.front(), found.plan, found.files, found.sources}, unfilled, gl::query_caps());
    return context != nullptr;
}

Exit write_texts(const AccuracyOptions& options, Found& found) {
    if (options.html.empty()) return complain(exit_usage, "--apply needs a folder to write to", "add -o FOLDER");
    if (!fill(found, options)) return exit_input;
    std::string error;
    const auto chosen = choose_changes(options.apply, found.changes, found.sources, error);
    if (!chosen)
        return complain(exit_input, error,
                        "list them by: " + accuracy_command(options.scenes.front(), options.choices) + " --list-found");
    std::vector<const Change*> changes;
    for (const Change& change : chosen->changes) changes.push_back(&change);
    const WrittenCopy copy =
        write_copy(options.scenes.front(), options.access, changed_texts(changes, found.sources), options.html);
    if (!copy.error.empty()) return complain(exit_input, copy.error);
    for (const Change* change : changes) fmt::print("{}\n", change_line(*change, found.sources));
    fmt::print("wrote {} ({})\n", utf8::printable(copy.scene), counted(copy.files.size(), "file"));
    return exit_fine;
}

bool fits(const CLI::App& command, const AccuracyOptions& options) {
    std::vector<std::string_view> fitting = access_options;
    fitting.insert(fitting.end(), {"SCENE", "--timeout", "--ladder"});
    if (options.list_found) {
        fitting.insert(fitting.end(), {"--list-found", "--json"});
        return excludes_others(command, fitting, "--list-found", "it only lists found rungs");
    }
    fitting.insert(fitting.end(), {"--apply", "--output", "--context"});
    return excludes_others(command, fitting, "--apply", "it only writes a scene");
}

std::string check_not_empty(const std::string& text) { return text.empty() ? "a number is missing" : ""; }

}  // namespace

void add_found_rungs(CLI::App& command, AccuracyOptions& options) {
    command.add_flag("--list-found", options.list_found, "list the found rungs with their numbers and measure nothing");
    command.add_option("--apply", options.apply, "write the scene with found rung 3, or 3+7, into the folder -o")
        ->check(check_not_empty);
}

bool only_texts(const AccuracyOptions& options) { return options.list_found || !options.apply.empty(); }

Exit write_found_rungs(const AccuracyOptions& options, const CLI::App& command) {
    if (!fits(command, options)) return exit_usage;
    if (options.scenes.size() != 1) return complain(exit_usage, "give one scene: found rungs are those of a scene");
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scenes.front()));
    const auto found = find_in(options.scenes.front(), options);
    if (!found) return exit_input;
    const Exit status = options.list_found ? list_found(options, *found) : write_texts(options, *found);
    deadline.rest();
    return status == exit_fine && found->errors ? exit_input : status;
}

}  // namespace snell::app
