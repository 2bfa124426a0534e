#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "parser/commands/commands.h"
#include "parser/read/parse.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/grade/idle_sliders.h"
#include "src/app/open/deadline.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/content/json.h"
#include "src/document/document.h"
#include "src/document/unsampled.h"
#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/runtime/resources/program.h"

namespace snell::app {

namespace {

struct CheckOptions {
    std::vector<std::string> scenes;
    bool json = false;
    std::string dump;  // "", "tokens", "statements", "scene" or "plan"
    bool lint = true;  // also reports what is valid but probably not meant
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds for each scene; after that the process ends
};

using Json = nlohmann::ordered_json;

Json span_json(const Span& span, const Sources& sources) {
    const Position begin = sources.position(span.file, span.begin);
    const Position end = sources.position(span.file, span.end);
    return {{"file", std::string(sources.name(span.file))},
            {"line", begin.line},
            {"column", begin.column},
            {"end_line", end.line},
            {"end_column", end.column}};
}

Json diagnostic_json(const Diagnostic& diagnostic, const Sources& sources) {
    Json json{{"severity", name(diagnostic.severity)}, {"code", diagnostic.code}, {"message", diagnostic.message}};
    if (diagnostic.has_span) json["at"] = span_json(diagnostic.span, sources);
    if (!diagnostic.help.empty()) json["help"] = diagnostic.help;
    for (const Span& span : diagnostic.also) json["also_at"].push_back(span_json(span, sources));
    for (const Note& note : diagnostic.notes)
        json["notes"].push_back({{"at", span_json(note.span, sources)}, {"message", note.message}});
    return json;
}

// Programs are compiled only if there is a context.
struct Checked {
    std::unique_ptr<Document> document;
    std::string dump;
};

void lint(const Plan& plan, Document& document) {
    document.diagnostics.append(lint::check(plan, document.sources, runtime::include_reader(*document.files)));
}

Checked check_scene(const std::string& path, const CheckOptions& options, const std::optional<gl::Caps>& caps) {
    Checked checked;
    const Access access = access_to(path, options.access, options.grade);
    if (caps && options.dump.empty()) {
        ProgressLine progress;
        checked.document = open_document(path, *caps, nullptr, options.lint ? PlanReader(lint) : nullptr,
                                         {.progress = progress.watcher()}, access);
        if (options.lint) add_idle_sliders(*checked.document, options.timeout > 0 ? options.timeout / 10 : 1e6);
        check_unsampled(*checked.document);  // sorts
        return checked;
    }
    checked.document = std::make_unique<Document>();
    Document& document = *checked.document;
    document.path = path;
    document.diagnostics = Diagnostics(access.limits);
    document.files = std::make_unique<Files>(scene_folder(path), access);
    auto parsed = parse_document(path, *document.files, document.sources, document.diagnostics);
    if (!parsed) return checked;
    if (options.dump == "tokens") checked.dump = dump_tokens(parsed->file, document.sources);
    if (options.dump == "statements") checked.dump = dump_statements(parsed->file, document.sources);
    if (options.dump == "scene") checked.dump = dump_scene(parsed->scene);
    if (options.dump.empty() || options.dump == "plan") {
        const Plan plan = make_plan(std::move(parsed->scene), *document.files, document.sources, document.diagnostics);
        if (options.dump == "plan") checked.dump = dump_plan(plan, document.sources);
        if (options.dump.empty() && options.lint) lint(plan, document);
    }
    document.diagnostics.sort();
    return checked;
}

std::optional<gl::Caps> caps_of(std::unique_ptr<HeadlessContext>& context) {
    std::string error;
    context = HeadlessContext::make({}, error);
    if (!context) return std::nullopt;
    return gl::query_caps();
}

Exit check(const CheckOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("starting OpenGL");
    std::unique_ptr<HeadlessContext> context;
    std::optional<gl::Caps> caps;
    if (options.dump.empty()) caps = caps_of(context);
    if (options.dump.empty() && !caps && !options.json)
        fmt::print(stderr, "snell: note: no graphics here: programs are not compiled\n");
    Json all = Json::array();
    bool errors = false;
    for (const std::string& path : options.scenes) {
        deadline.begin(fmt::format("checking '{}'", path));
        const Checked checked = check_scene(path, options, caps);
        deadline.rest();  // a reader of the output may be slow
        const Document& document = *checked.document;
        errors = errors || document.diagnostics.has_errors();
        std::fwrite(checked.dump.data(), 1, checked.dump.size(), stdout);
        if (options.json) {
            Json scene{{"scene", path},
                       {"errors", document.diagnostics.errors()},
                       {"warnings", document.diagnostics.warnings()},
                       {"diagnostics", Json::array()}};
            for (const Diagnostic& diagnostic : document.diagnostics.items())
                scene["diagnostics"].push_back(diagnostic_json(diagnostic, document.sources));
            all.push_back(std::move(scene));
        } else {
            const std::string text = snell::render(document.diagnostics, document.sources);
            std::fwrite(text.data(), 1, text.size(), options.dump.empty() ? stdout : stderr);
        }
    }
    if (options.json) fmt::print("{}\n", content::json_text(all));
    return errors ? exit_input : exit_fine;
}

}  // namespace

Run add_check(CLI::App& command) {
    auto options = std::make_shared<CheckOptions>();
    command.add_option("SCENE", options->scenes)->required();
    add_access(command, options->access);
    add_grade(command, options->grade);
    add_timeout(command, options->timeout, "each scene");
    command.add_flag("--json", options->json, "print JSON");
    command.add_flag("!--no-lint", options->lint, "omit what is allowed but probably not intended");
    command.add_option("--dump", options->dump, "print one stage of the reading")
        ->check(CLI::IsMember({"tokens", "statements", "scene", "plan"}));
    return [options] { return check(*options); };
}

}  // namespace snell::app
