#include "src/app/commands/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "src/accuracy/clock.h"
#include "src/accuracy/statistics.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/deadline.h"
#include "src/app/open/document.h"
#include "src/app/open/exit_status.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/content/json.h"
#include "src/gl/exact_target.h"
#include "src/gl/present.h"
#include "src/lint/lint.h"
#include "src/runtime/resources/program.h"
#include "src/runtime/resources/stopwatch.h"

namespace snell::app {

namespace {

struct ExplainOptions {
    std::string scene;
    bool json = false, no_time = false;
    bool specialise = true;  // programs are compiled for the values that they have
    std::vector<std::string> sets, ladders;
    std::optional<std::pair<int, int>> size;
    double time = 0;
    int rounds = 31;
    std::string context;
    Access access;
    double timeout = 20;  // in seconds, for the whole command; frames are timed as long as there is time
};

using Json = nlohmann::ordered_json;
using Paid = Explanation::Paid;

constexpr double most_time = 20e3;  // milliseconds of timing frames
constexpr double most_share = .9;   // of the time left of --timeout: the last frame may take longer than the others

int line_of(const Span& span, const Sources& sources) { return sources.position(span.file, span.begin).line; }

std::string place_of(const Span& span, const Sources& sources) {
    return fmt::format("{}:{}", sources.name(span.file), line_of(span, sources));
}

std::string bytes_text(std::uint64_t bytes) {
    if (bytes == 0) return "";
    if (bytes < 1024 * 1024) return fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024);
    return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1024 / 1024);
}

// Times frames of which some draws are left out.
class Rounds {
public:
    Rounds(Runtime& runtime, const Frame& frame, const Surface& surface, bool software)
        : runtime_(runtime), frame_(frame), surface_(surface), software_(software) {}

    FrameCost once(const std::vector<bool>* hidden, int frames = 1) {
        Frame frame = frame_;
        frame.hidden = hidden;
        gl::finish();
        const bool query = !software_ && query_.available();
        if (query) query_.begin();
        const double cpu = accuracy::cpu_milliseconds();
        const runtime::Stopwatch watch;
        for (int i = 0; i < frames; ++i) {
            runtime_.draw(frame, surface_);
            gl::finish();
        }
        FrameCost cost{(accuracy::cpu_milliseconds() - cpu) / frames, watch.milliseconds() / frames, std::nullopt};
        if (query) cost.gpu = query_.end() / frames;
        return cost;
    }

    // A timer query is trusted if it agrees with the wall clock on a heavy load.
    bool calibrated() {
        if (software_ || !query_.available()) return false;
        const int frames = std::clamp(static_cast<int>(200 / std::max(once(nullptr).wall, .01)), 1, 1000);
        const FrameCost heavy = once(nullptr, frames);
        return heavy.gpu && *heavy.gpu > .8 * heavy.wall && *heavy.gpu < 1.2 * heavy.wall;
    }

private:
    Runtime& runtime_;
    Frame frame_;
    Surface surface_;
    bool software_;
    gl::TimerQuery query_;
};

// Compares times of the same rounds; the last round may be incomplete.
FrameCost median_difference(const std::vector<FrameCost>& with, const std::vector<FrameCost>& without, bool gpu) {
    const auto median = [&](auto value) {
        std::vector<double> differences;
        for (std::size_t i = 0; i < without.size(); ++i) differences.push_back(value(with[i]) - value(without[i]));
        return accuracy::median(differences);
    };
    FrameCost cost{median([](const FrameCost& c) { return c.cpu; }), median([](const FrameCost& c) { return c.wall; }),
                   std::nullopt};
    if (gpu) cost.gpu = median([](const FrameCost& c) { return c.gpu.value_or(0); });
    return cost;
}

double shown(const FrameCost& cost, bool software) { return cost.gpu ? *cost.gpu : software ? cost.cpu : cost.wall; }

Json cost_json(const FrameCost& cost) {
    return {{"cpu_ms", cost.cpu}, {"wall_ms", cost.wall}, {"gpu_ms", cost.gpu ? Json(*cost.gpu) : Json(nullptr)}};
}

Json counters_json(const Counters& counters) {
    Json json = Json::object();
    for (const CounterName& counter : counter_names()) json[std::string(counter.name)] = counters.*counter.value;
    return json;
}

Json span_json(const std::optional<Span>& span, const Sources& sources) {
    if (!span) return nullptr;
    return {{"file", sources.name(span->file)}, {"line", line_of(*span, sources)}};
}

// Returns the parts that are left out in turns. Cube passes that are kept are not among them: they would be drawn only
// because their draws come and go.
std::vector<Paid*> timed_parts(Explanation& explanation) {
    std::vector<Paid*> parts;
    std::set<Index> kept;
    for (const Paid& paid : explanation.paid)
        if (paid.kept) kept.insert(paid.draws.begin(), paid.draws.end());
    for (Paid& paid : explanation.paid)
        if (!paid.draws.empty() && std::ranges::none_of(paid.draws, [&](Index draw) { return kept.contains(draw); }))
            parts.push_back(&paid);
    return parts;
}

}  // namespace

void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing) {
    const runtime::Stopwatch watch;
    Rounds clock(runtime, frame, surface, report.caps.software);
    std::vector<Paid*> parts = timed_parts(report.explanation);
    std::vector<std::vector<bool>> hidden;
    for (const Paid* part : parts) {
        hidden.emplace_back(runtime.scene().draws.size(), false);
        for (const Index draw : part->draws) hidden.back()[draw] = true;
    }
    const bool gpu = clock.calibrated();
    std::vector<FrameCost> whole;
    std::vector<std::vector<FrameCost>> without(parts.size());
    double longest = timing.frame;
    const auto fits = [&] { return watch.milliseconds() + longest < timing.milliseconds; };
    const auto timed = [&](const std::vector<bool>* left_out) {
        const double share = std::max(watch.milliseconds() / std::max(timing.milliseconds, 1.),
                                      static_cast<double>(whole.size()) / static_cast<double>(timing.rounds));
        if (timing.report) timing.report(static_cast<int>(whole.size()), share);
        const FrameCost cost = clock.once(left_out);
        longest = std::max(longest, cost.wall);
        return cost;
    };
    for (int round = 0; round < timing.rounds && fits(); ++round) {
        whole.push_back(timed(nullptr));
        for (std::size_t i = 0; i < parts.size() && fits(); ++i) without[i].push_back(timed(&hidden[i]));
    }
    if (whole.empty()) return;
    report.asked = timing.rounds;
    report.rounds = static_cast<int>(whole.size());
    report.clock = gpu                    ? "timer queries of the GPU"
                   : report.caps.software ? "CPU time of the process"
                                          : "the wall's clock";
    report.frame = median_difference(whole, std::vector<FrameCost>(whole.size()), gpu);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (!without[i].empty()) parts[i]->frame = median_difference(whole, without[i], gpu);
    std::vector<double> values;
    for (FrameCost& cost : whole) {
        if (!gpu) cost.gpu.reset();
        values.push_back(shown(cost, report.caps.software));
    }
    report.spread = accuracy::mad(values);
}

std::string explain_text(const ExplainReport& report, const Sources& sources) {
    const bool timed = !report.clock.empty();
    std::string text = fmt::format("{}  {}x{}, {}", report.scene, report.width, report.height, report.caps.renderer);
    if (timed)
        text += fmt::format("  frame {:.2f} ms (±{:.2f}), {}, {} rounds{}", shown(report.frame, report.caps.software),
                            report.spread, report.clock, report.rounds,
                            report.rounds < report.asked ? fmt::format(" of {}: time was up", report.asked) : "");
    text += fmt::format("\ndrawn  {}\n\n{:<52}{:>10}{:>11}{:>11}\n", report.explanation.redraw, "PAYS FOR", "load ms",
                        "frame ms", "memory");
    const auto number = [](std::optional<double> ms) { return ms ? fmt::format("{:.2f}", *ms) : std::string("-"); };
    for (const Paid& paid : report.explanation.paid) {
        std::string what = fmt::format("  {} {}", name(paid.kind), paid.name);
        if (paid.triangles) what += fmt::format(", {} triangles", paid.triangles);
        const auto frame = paid.frame ? std::optional(shown(*paid.frame, report.caps.software)) : std::nullopt;
        text += fmt::format("{:<52}{:>10}{:>11}{:>11}\n", what, number(paid.load_ms), number(frame),
                            bytes_text(paid.bytes));
        text += fmt::format("      {}{}{}\n", paid.span ? place_of(*paid.span, sources) : "", paid.span ? ": " : "",
                            paid.why);
    }
    if (!report.explanation.unpaid.empty()) text += "\nNOT PAID FOR\n";
    for (const auto& unpaid : report.explanation.unpaid) text += fmt::format("  {:<24}{}\n", unpaid.name, unpaid.why);
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
    return text;
}

namespace {

// Has "schema" 1 and the keys that docs/architecture.md lists.
Json explain_json(const ExplainReport& report, const Sources& sources) {
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
    json["pays"] = Json::array();
    for (const Paid& paid : report.explanation.paid) {
        Json one{{"kind", name(paid.kind)}, {"name", paid.name}, {"why", paid.why}};
        one["at"] = span_json(paid.span, sources);
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
        json["unused"].push_back({{"name", unused.name}, {"why", unused.why}, {"at", span_json(unused.span, sources)}});
    json["lints"] = Json::array();
    for (const Diagnostic& lint : report.lints.items())
        json["lints"].push_back(
            {{"code", lint.code}, {"message", lint.message}, {"at", span_json(lint.span, sources)}});
    json["counters"] = {{"load", counters_json(report.load)}, {"frame", counters_json(report.per_frame)}};
    return json;
}

// What outlives the steps of the command.
struct Running {
    const runtime::Stopwatch& watch;
    Deadline& deadline;
    ProgressLine& progress;
};

// Draws two frames and counts, then times frames for as long as there is time.
void measure(ExplainReport& report, Document& document, const ExplainOptions& options, const Running& running) {
    Runtime& runtime = *document.runtime;
    const auto& window = document.scene().window_size;
    std::tie(report.width, report.height) = options.size.value_or(std::pair(window[0], window[1]));
    const gl::Target target = gl::make_target(report.width, report.height, 1);
    const Surface surface{target.framebuffer.get(), report.width, report.height};
    const View view;
    const Frame frame{.time = options.time, .view = view, .controls = document.controls};
    running.deadline.now(fmt::format("drawing '{}'", options.scene));
    runtime.draw(frame, surface);
    gl::finish();
    report.load = runtime.counters();
    const runtime::Stopwatch second;
    runtime.draw(frame, surface);
    gl::finish();
    const double took = second.milliseconds();
    for (const CounterName& counter : counter_names())
        report.per_frame.*counter.value = runtime.counters().*counter.value - report.load.*counter.value;
    report.explanation = runtime.explain();
    if (!options.no_time) {
        const double left = most_share * (options.timeout * 1e3 - running.watch.milliseconds());
        running.progress.begin();
        time_frames(report, runtime, frame, surface,
                    {options.rounds, options.timeout > 0 ? std::min(left, most_time) : most_time, took,
                     [&](int round, double share) {
                         running.progress.show(fmt::format("timing frames: round {} of {}", round + 1, options.rounds),
                                               share);
                     }});
        running.progress.clear();
        if (report.clock.empty())
            fmt::print(stderr,
                       "snell: warning: frames are not timed: one takes {:.1f} s\n   help: take a smaller --size or a "
                       "longer --timeout\n",
                       took / 1e3);
    }
}

Exit explain(const ExplainOptions& options) {
    const runtime::Stopwatch watch;
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    ExplainReport report;
    report.scene = options.scene;
    report.caps = gl::query_caps();
    Diagnostics chosen;
    const auto choose = [&](const Scene& scene, Rungs& rungs) {
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, chosen);
    };
    ProgressLine progress;
    RuntimeOptions how{.progress = progress.watcher()};
    if (options.specialise)
        how.settle = [&](Controls& controls, const Scene& scene) {
            Diagnostics unheard;
            for (const std::string& set : options.sets) set_control(controls, scene, set, unheard);
        };
    const auto document = open_document(
        options.scene, report.caps, choose,
        [&](const Plan& plan, Document& opened) {
            report.lints = lint::check(plan, opened.sources, runtime::include_reader(*opened.files));
        },
        how, options.access);
    if (document->runtime)
        for (const std::string& set : options.sets) set_control(document->controls, document->scene(), set, chosen);
    document->diagnostics.append(chosen);
    Diagnostics errors;
    for (const Diagnostic& diagnostic : document->diagnostics.items())
        if (diagnostic.severity == Severity::error) errors.add(diagnostic);
    fmt::print(stderr, "{}", snell::render(errors, document->sources));
    if (!document->runtime) return exit_input;
    measure(report, *document, options, {watch, deadline, progress});
    deadline.rest();
    const std::string text = options.json ? content::json_text(explain_json(report, document->sources)) + "\n"
                                          : explain_text(report, document->sources);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return errors.has_errors() ? exit_input : exit_fine;
}

}  // namespace

Run add_explain(CLI::App& command) {
    auto options = std::make_shared<ExplainOptions>();
    add_access(command, options->access);
    add_timeout(command, options->timeout, "all of it; expensive frames are timed in fewer rounds");
    command.footer("Times are of this machine, now; those of passes are by difference.");
    command.add_option("SCENE", options->scene)->required();
    command.add_flag("--json", options->json, "print JSON");
    command.add_flag("--no-time", options->no_time, "do not time frames");
    command.add_option("--reps", options->rounds, "rounds, in each of which every pass is left out once")
        ->check(CLI::Range(3, 10000));
    add_size(command, options->size, "WIDTHxHEIGHT (default: the scene's)");
    add_time(command, options->time);
    add_values(command, options->sets, options->ladders);
    add_specialise(command, options->specialise);
    add_context(command, options->context);
    return [options] { return size_fits(options->size, options->access.limits) ? explain(*options) : exit_usage; };
}

}  // namespace snell::app
