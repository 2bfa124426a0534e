#include "src/app/commands/check.h"

#include <array>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "parser/commands/commands.h"
#include "parser/read/parse.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/grade/judge.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/app/open/version.h"
#include "src/app/picture/non_finite.h"
#include "src/app/picture/outputs.h"
#include "src/content/text_forms.h"
#include "src/lint/lint.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"

namespace snell::app {

namespace {

struct CheckOptions {
    std::vector<std::string> scenes;
    std::string json, sarif;     // files
    bool lines = false;          // one line for each message
    bool warnings_fail = false;  // warnings give the status of errors
    std::string dump;            // "", "tokens", "statements", "scene" or "plan"
    bool lint = true;            // also reports what is valid but probably not meant
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds for each scene; after that the process ends
};

using Json = nlohmann::ordered_json;

// Programs are compiled only if there is a context.
struct Checked {
    std::unique_ptr<Document> document;
    std::string dump;
};

void lint(const Plan& plan, Document& document) {
    document.diagnostics.append(lint::check(plan, document.sources, shader_includes(*document.files)));
}

Checked check_scene(const std::string& path, const CheckOptions& options, const std::optional<gl::Caps>& caps) {
    Checked checked;
    const Access access = access_to(path, options.access, options.grade);
    if (caps && options.dump.empty()) {
        ProgressLine progress;
        checked.document =
            checked_document(path, *caps, options.lint, options.timeout, {.progress = progress.watcher()}, access);
        return checked;
    }
    checked.document = std::make_unique<Document>();
    Document& document = *checked.document;
    document.path = path;
    document.diagnostics = Diagnostics(access.limits);
    document.files = std::make_unique<Files>(scene_folder(path), access);
    if (options.dump.empty() || options.dump == "plan") {
        const auto plan = read_plan(path, *document.files, document.sources, document.diagnostics);
        if (plan && options.dump == "plan") checked.dump = dump_plan(*plan, document.sources);
        if (plan && options.dump.empty() && options.lint) lint(*plan, document);
    } else if (const auto parsed = parse_document(path, *document.files, document.sources, document.diagnostics)) {
        if (options.dump == "tokens") checked.dump = dump_tokens(parsed->file, document.sources);
        if (options.dump == "statements") checked.dump = dump_statements(parsed->file, document.sources);
        if (options.dump == "scene") checked.dump = dump_scene(parsed->scene);
    }
    document.diagnostics.sort();
    return checked;
}

std::optional<gl::Caps> caps_of(std::unique_ptr<HeadlessContext>& context) {
    std::string error;
    context = HeadlessContext::make({}, error);
    if (!context && short_of_memory(whole_driver)) out_of_memory();
    if (!context) return std::nullopt;
    return gl::query_caps();
}

void print_messages(const Document& document, bool lines, std::FILE* to) {
    for (const Diagnostic& diagnostic : document.diagnostics.items()) {
        std::string text = snell::render(diagnostic, document.sources);
        if (lines) text.resize(std::min(text.find('\n') + 1, text.size()));
        std::fwrite(text.data(), 1, text.size(), to);
    }
}

bool write_json_to(const std::string& file, const Json& json) {
    return file.empty() || write_output(file, content::json_text(json) + '\n');
}

Exit check(const CheckOptions& options) {
    Deadline deadline(options.timeout);
    deadline.begin("reading the scenes");
    const std::array outputs{options.json, options.sarif};
    if (const Exit refused = check_outputs(outputs, read_by(options.scenes, outputs, options.access, options.grade));
        refused != exit_fine)
        return refused;
    deadline.begin("starting OpenGL");
    std::unique_ptr<HeadlessContext> context;
    std::optional<gl::Caps> caps;
    const bool text = options.json.empty() && options.sarif.empty();
    if (options.dump.empty()) caps = caps_of(context);
    if (options.dump.empty() && !caps && text)
        fmt::print(stderr, "snell: note: no graphics here: programs are not compiled\n");
    Json all = Json::array(), sarif = empty_sarif();
    bool errors = false;
    for (const std::string& path : options.scenes) {
        deadline.begin(fmt::format("checking '{}'", path));
        const Checked checked = check_scene(path, options, caps);
        deadline.rest();  // a reader of the output may be slow
        const Document& document = *checked.document;
        errors = errors || document.diagnostics.has_errors() ||
                 (options.warnings_fail && document.diagnostics.warnings() > 0);
        std::fwrite(checked.dump.data(), 1, checked.dump.size(), stdout);
        all.push_back(checked_json(path, document));
        add_sarif(sarif, document);
        if (text) print_messages(document, options.lines, options.dump.empty() ? stdout : stderr);
    }
    if (!write_json_to(options.json, all) || (!options.sarif.empty() && !write_json_to(options.sarif, sarif)))
        return exit_input;
    return errors ? exit_input : exit_fine;
}

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
    for (const Fix& fix : diagnostic.fixes)
        json["fixes"].push_back({{"at", span_json(fix.span, sources)}, {"text", fix.text}});
    return json;
}

Json place(const Span& span, const Sources& sources) {
    const Position begin = sources.position(span.file, span.begin), end = sources.position(span.file, span.end);
    return {{"physicalLocation",
             {{"artifactLocation", {{"uri", content::escaped_address(sources.name(span.file))}}},
              {"region",
               {{"startLine", begin.line},
                {"startColumn", begin.column},
                {"endLine", end.line},
                {"endColumn", std::max(end.column, end.line == begin.line ? begin.column + 1 : 1)}}}}}};
}

}  // namespace

std::unique_ptr<Document> checked_document(const std::string& path, const gl::Caps& caps, bool wants_lint,
                                           double seconds, const RuntimeOptions& options, const Access& access) {
    bool risk = false;
    const auto read = [&](const Plan& plan, Document& of) {
        lint(plan, of);
        risk = may_give_nan(plan, of.sources);
    };
    auto document = open_document(path, caps, nullptr, wants_lint ? PlanReader(read) : nullptr, options, access);
    if (wants_lint) add_idle_sliders(*document, seconds > 0 ? seconds / 10 : 1e6);
    if (risk) warn_of_nan(*document);
    check_unsampled(*document);  // sorts
    return document;
}

Run add_check(CLI::App& command) {
    auto options = std::make_shared<CheckOptions>();
    command.add_option("SCENE", options->scenes)->required();
    add_access(command, options->access);
    add_grade(command, options->grade);
    add_timeout(command, options->timeout, "each scene");
    add_json(command, options->json, "print JSON");
    command
        .add_flag("--sarif{/dev/stdout}", options->sarif, "print SARIF 2.1.0, for CI services; --sarif=FILE writes it")
        ->check(check_file_name);
    command.add_flag("--lines", options->lines,
                     "print one line for each message, without excerpts: for problem matchers");
    command.add_flag("--werror", options->warnings_fail, "status 1 for warnings, too");
    command.add_flag("!--no-lint", options->lint, "omit what is allowed but probably not intended");
    command.add_option("--dump", options->dump, "print one stage of the reading")
        ->check(CLI::IsMember({"tokens", "statements", "scene", "plan"}));
    return [options] { return check(*options); };
}

Json checked_json(const std::string& scene, const Document& document) {
    Json json{{"schema", 1},
              {"scene", scene},
              {"errors", document.diagnostics.errors()},
              {"warnings", document.diagnostics.warnings()},
              {"diagnostics", Json::array()}};
    for (const Diagnostic& diagnostic : document.diagnostics.items())
        json["diagnostics"].push_back(diagnostic_json(diagnostic, document.sources));
    return json;
}

Json empty_sarif() {
    const Json driver{{"name", "snell"}, {"version", version()}, {"rules", Json::array()}};
    return {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
            {"version", "2.1.0"},
            {"runs",
             Json::array(
                 {{{"tool", {{"driver", driver}}}, {"columnKind", "unicodeCodePoints"}, {"results", Json::array()}}})}};
}

void add_sarif(Json& log, const Document& document) {
    Json& run = log["runs"][0];
    Json& rules = run["tool"]["driver"]["rules"];
    for (const Diagnostic& diagnostic : document.diagnostics.items()) {
        const Json rule{{"id", diagnostic.code}};
        if (std::find(rules.begin(), rules.end(), rule) == rules.end()) rules.push_back(rule);
        const std::string text =
            diagnostic.help.empty() ? diagnostic.message : fmt::format("{} ({})", diagnostic.message, diagnostic.help);
        Json result{{"ruleId", diagnostic.code}, {"level", name(diagnostic.severity)}, {"message", {{"text", text}}}};
        if (diagnostic.has_span)
            result["locations"] = Json::array({place(diagnostic.span, document.sources)});
        else
            result["locations"] = Json::array(
                {{{"physicalLocation", {{"artifactLocation", {{"uri", content::escaped_address(document.path)}}}}}}});
        run["results"].push_back(std::move(result));
    }
}

}  // namespace snell::app
