// The report of `snell explain`, as text and as JSON.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "parser/text/words.h"
#include "src/app/commands/explain/explain.h"
#include "src/content/text_forms.h"

namespace snell::app {

namespace {

using Json = nlohmann::ordered_json;
using Paid = Explanation::Paid;
using SwitchedOff = Explanation::SwitchedOff;

int line_of(const Span& span, const Sources& sources) { return sources.position(span.file, span.begin).line; }

std::string place_of(const Span& span, const Sources& sources) {
    return fmt::format("{}:{}", sources.name(span.file), line_of(span, sources));
}

std::string bytes_text(std::uint64_t bytes) {
    if (bytes == 0) return "";
    if (bytes < 999'950) return fmt::format("{:.1f} kB", static_cast<double>(bytes) / 1e3);
    return fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

std::optional<double> chosen(const std::optional<FrameCost>& cost, const ExplainReport& report) {
    return cost ? std::optional(shown(*cost, report.caps.software)) : std::nullopt;
}

std::string milliseconds(std::optional<double> ms) { return ms ? fmt::format("{:.2f}", *ms) : std::string("-"); }

std::string part_text(const SwitchedOff::Part& part) {
    using Kind = Explanation::Kind;
    const bool named = part.kind == Kind::sampler || part.kind == Kind::uniform;  // the name begins with the type
    std::string text = named ? part.name : fmt::format("{} {}", name(part.kind), part.name);
    if (!part.functions.empty()) text += fmt::format(", named in {}", fmt::join(part.functions, ", "));
    if (!part.files.empty()) text += fmt::format(", {} not opened", counted(part.files.size(), "file"));
    return text;
}

std::string switched_off_text(const ExplainReport& report, const Sources& sources) {
    if (report.explanation.switched_off.empty()) return "";
    const auto row = [](std::string_view what, std::string_view saves, std::uint64_t bytes) {
        return fmt::format("{:<52}{:>21}{:>11}\n", what, saves, bytes_text(bytes));
    };
    std::string text = fmt::format("\n{:<52}{:>21}{:>11}\n", "SWITCHED OFF", "saves ms", "files");
    for (const SwitchedOff& off : report.explanation.switched_off) {
        std::uint64_t bytes = 0;
        for (const SwitchedOff::Part& part : off.parts) bytes += part.bytes;
        const std::string what = off.uniform.empty()
                                     ? fmt::format("  by values of {} only together", off.program_name)
                                     : fmt::format("  by {} = {} of {}", off.uniform, off.value, off.program_name);
        text += row(what, milliseconds(chosen(off.saved, report)), bytes);
        if (off.span) {
            const Position at = sources.position(off.span->file, off.span->begin);
            text += fmt::format("      {}:{}:{}\n", sources.name(off.span->file), at.line, at.column);
        }
        for (const SwitchedOff::Part& part : off.parts) text += fmt::format("        {}\n", part_text(part));
    }
    if (report.saved)
        text += row("  in all, against programs for any values", milliseconds(chosen(report.saved, report)), 0);
    return text;
}

// Names and texts of scenes go to the terminal, and may hold anything.
std::string printable_lines(std::string_view text) {
    std::string lines;
    for (const std::string_view line : split(text, '\n')) lines += utf8::printable(line) + "\n";
    return lines;
}

std::string without_effect_text(const ExplainReport& report) {
    if (!report.without_effect) return "";
    const WithoutEffect& found = *report.without_effect;
    std::string text = fmt::format("{:<63}{:>10}{:>11}\n", "CHANGES 0 PIXELS", "frame ms", "memory");
    for (const WithoutEffect::Row& row : found.rows) {
        text += fmt::format("  {:<61}{:>10}{:>11}\n", row.what, milliseconds(chosen(row.frame, report)),
                            bytes_text(static_cast<std::uint64_t>(std::max<std::int64_t>(row.gpu_bytes, 0))));
        text += fmt::format("      {}: found rung {}{}\n", row.place, row.rung,
                            row.load_ms.value_or(0) > 0 ? fmt::format(", {:.3g} ms of loading", *row.load_ms) : "");
    }
    if (!found.cannot_say.empty()) return text + fmt::format("  can't say: {}\n\n", found.cannot_say);
    const std::string_view late = "the time was up before all were tried: give a longer --timeout";
    if (found.tried == 0) return text + fmt::format("  {}\n\n", found.late ? late : "nothing can be left out");
    return text + fmt::format("  {} of {} that were left out, at {} places, {} of which were held out{}{}\n\n",
                              found.rows.size(), found.tried, found.places, found.held_out, found.late ? "; " : "",
                              found.late ? late : "");
}

}  // namespace

std::string explain_text(const ExplainReport& report, const Sources& sources) {
    const bool timed = !report.clock.empty();
    std::string text = fmt::format("{}  {}x{}, {}", report.scene, report.width, report.height, report.caps.renderer);
    if (timed)
        text += fmt::format("  frame {:.2f} ms (±{:.2f}), {}, {} rounds{}", shown(report.frame, report.caps.software),
                            report.spread, report.clock, report.rounds,
                            report.rounds < report.asked ? fmt::format(" of {}: time was up", report.asked) : "");
    text += fmt::format("\ndrawn  {}\n\n", report.explanation.redraw) + without_effect_text(report);
    text += fmt::format("{:<52}{:>10}{:>11}{:>11}\n", "PAYS FOR", "load ms", "frame ms", "memory");
    for (const Paid& paid : report.explanation.paid) {
        std::string what = fmt::format("  {} {}", name(paid.kind), paid.name);
        if (paid.triangles) what += fmt::format(", {} triangles", paid.triangles);
        text += fmt::format("{:<52}{:>10}{:>11}{:>11}\n", what, milliseconds(paid.load_ms),
                            milliseconds(chosen(paid.frame, report)), bytes_text(paid.bytes));
        text += fmt::format("      {}{}{}\n", paid.span ? place_of(*paid.span, sources) : "", paid.span ? ": " : "",
                            paid.why);
    }
    if (!report.explanation.unpaid.empty()) text += "\nNOT PAID FOR\n";
    for (const auto& unpaid : report.explanation.unpaid) text += fmt::format("  {:<24}{}\n", unpaid.name, unpaid.why);
    text += switched_off_text(report, sources);
    if (!report.explanation.unused.empty()) text += "\nDECLARED BUT UNUSED\n";
    for (const auto& unused : report.explanation.unused)
        text += fmt::format("  {:<24}{}: {}\n", unused.name, place_of(unused.span, sources), unused.why);
    if (!report.lints.empty()) text += "\nLINTS\n";
    for (const Diagnostic& lint : report.lints.items())
        text += fmt::format("  {} {} [{}]\n", place_of(lint.span, sources), lint.message, lint.code);
    text += "\nCOUNTED                      loading  each frame\n";
    for (const CounterName& counter : counter_names()) {
        const std::uint64_t load = report.load.*counter.value, frame = report.per_frame.*counter.value;
        if (load || frame) text += fmt::format("  {:<22}{:>12}{:>12}\n", counter.name, load, frame);
    }
    return printable_lines(text);
}

namespace {

Json cost_json(const FrameCost& cost) {
    return {{"cpu_ms", cost.cpu}, {"wall_ms", cost.wall}, {"gpu_ms", cost.gpu ? Json(*cost.gpu) : Json(nullptr)}};
}

Json counters_json(const Counters& counters) {
    Json json = Json::object();
    for (const CounterName& counter : counter_names()) json[std::string(counter.name)] = counters.*counter.value;
    return json;
}

Json line_json(const std::optional<Span>& span, const Sources& sources) {
    if (!span) return nullptr;
    return {{"file", sources.name(span->file)}, {"line", line_of(*span, sources)}};
}

Json place_json(const std::optional<Span>& span, const Sources& sources) {
    Json json = line_json(span, sources);
    if (span) json["column"] = sources.position(span->file, span->begin).column;
    return json;
}

// What all values save together is the last entry, if it was measured.
Json switched_off_json(const ExplainReport& report, const Sources& sources) {
    Json json = Json::array();
    const auto saves = [](const std::optional<FrameCost>& cost) { return cost ? cost_json(*cost) : Json(nullptr); };
    for (const SwitchedOff& off : report.explanation.switched_off) {
        const bool one = !off.uniform.empty();
        Json row{{"uniform", one ? Json(off.uniform) : Json(nullptr)},
                 {"program", off.program_name},
                 {"value", one ? Json(off.value) : Json(nullptr)}};
        row["at"] = place_json(off.span, sources);
        row["off"] = Json::array();
        for (const SwitchedOff::Part& part : off.parts) {
            row["off"].push_back({{"kind", name(part.kind)},
                                  {"name", part.name},
                                  {"functions", part.functions},
                                  {"files", part.files},
                                  {"bytes", part.bytes}});
            row["off"].back()["at"] = place_json(part.span, sources);
        }
        row["saves"] = saves(off.saved);
        json.push_back(std::move(row));
    }
    if (report.saved)
        json.push_back({{"uniform", nullptr},
                        {"program", nullptr},
                        {"value", nullptr},
                        {"at", nullptr},
                        {"off", Json::array()},
                        {"saves", saves(report.saved)}});
    return json;
}

Json without_effect_json(const WithoutEffect& found) {
    Json json{{"cannot_say", found.cannot_say},
              {"tried", found.tried},
              {"places", found.places},
              {"held_out", found.held_out},
              {"late", found.late}};
    json["rows"] = Json::array();
    for (const WithoutEffect::Row& row : found.rows)
        json["rows"].push_back({{"rung", row.rung},
                                {"place", row.place},
                                {"what", row.what},
                                {"frame", row.frame ? cost_json(*row.frame) : Json(nullptr)},
                                {"gpu_bytes", row.gpu_bytes},
                                {"bytes_decoded", row.bytes_decoded},
                                {"load_ms", row.load_ms ? Json(*row.load_ms) : Json(nullptr)}});
    return json;
}

}  // namespace

std::string explain_json(const ExplainReport& report, const Sources& sources) {
    Json json{{"schema", 1},
              {"scene", report.scene},
              {"size", {report.width, report.height}},
              {"renderer", report.caps.renderer},
              {"gl", report.caps.version},
              {"clock", report.clock.empty() ? Json(nullptr) : Json(report.clock)},
              {"rounds", report.rounds},
              {"frame", report.clock.empty() ? Json(nullptr) : cost_json(report.frame)}};
    if (!report.clock.empty()) json["frame"]["spread_ms"] = report.spread;
    json["redraw"] = report.explanation.redraw;
    if (report.without_effect) json["without_effect"] = without_effect_json(*report.without_effect);
    json["pays"] = Json::array();
    for (const Paid& paid : report.explanation.paid) {
        Json one{{"kind", name(paid.kind)}, {"name", paid.name}, {"why", paid.why}};
        one["at"] = line_json(paid.span, sources);
        one["bytes"] = paid.bytes;
        one["load_ms"] = paid.load_ms ? Json(*paid.load_ms) : Json(nullptr);
        one["frame"] = paid.frame ? cost_json(*paid.frame) : Json(nullptr);
        if (paid.kind == Explanation::Kind::pass) one["draws"] = paid.draws.size();
        if (paid.triangles) one["triangles"] = paid.triangles;
        json["pays"].push_back(std::move(one));
    }
    json["not_paid"] = Json::array();
    for (const auto& unpaid : report.explanation.unpaid)
        json["not_paid"].push_back({{"name", unpaid.name}, {"why", unpaid.why}});
    json["unused"] = Json::array();
    for (const auto& unused : report.explanation.unused)
        json["unused"].push_back({{"name", unused.name}, {"why", unused.why}, {"at", line_json(unused.span, sources)}});
    json["switched_off"] = switched_off_json(report, sources);
    json["lints"] = Json::array();
    for (const Diagnostic& lint : report.lints.items())
        json["lints"].push_back(
            {{"code", lint.code}, {"message", lint.message}, {"at", line_json(lint.span, sources)}});
    json["counters"] = {{"load", counters_json(report.load)}, {"frame", counters_json(report.per_frame)}};
    return content::json_text(json) + "\n";
}

}  // namespace snell::app
