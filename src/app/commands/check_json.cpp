#include "src/app/commands/check_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/app/open/version.h"
#include "src/content/uri.h"

namespace snell::app {

namespace {

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
