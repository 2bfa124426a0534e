#include "src/app/commands/explain/explain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/rounds.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/app/picture/outputs.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/gl/target.h"
#include "src/lint/lint.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/program.h"

namespace snell::app {

namespace {

struct ExplainOptions {
    std::string scene;
    std::string json;  // a file
    bool no_time = false;
    bool without_effect = false;  // tries what changes no pixel
    bool specialise = true;       // programs are compiled for the values that they have
    std::vector<std::string> sets, ladders;
    std::optional<std::pair<int, int>> size;
    double time = 0;
    int rounds = 31;
    std::string context;
    Access access;
    double timeout = 20;  // in seconds, for the whole command; frames are timed as long as there is time
};

constexpr double most_time = 20e3;  // milliseconds of timing frames
constexpr double most_share = .9;   // of the time left of --timeout: the last frame may take longer than the others

// What outlives the steps of the command.
struct Running {
    const runtime::Stopwatch& watch;
    Deadline& deadline;
    ProgressLine& progress;
};

// Milliseconds that may be spent on timing.
double time_left(const ExplainOptions& options, const Running& running) {
    if (options.timeout <= 0) return most_time;
    return std::min(most_share * (options.timeout * 1e3 - running.watch.milliseconds()), most_time);
}

RungChooser rungs_of(const ExplainOptions& options, Diagnostics& diagnostics) {
    return [&](const Scene& scene, Rungs& rungs) {
        for (const std::string& ladder : options.ladders) choose_rung(rungs, scene, ladder, diagnostics);
    };
}

// As RuntimeOptions::settle, less one uniform.
std::function<void(Controls&, const Scene&)> values_of(const ExplainOptions& options, Index program = none,
                                                       const std::string& without = "") {
    return [&options, program, without](Controls& controls, const Scene& scene) {
        Diagnostics unheard;
        for (const std::string& set : options.sets) set_control(controls, scene, set, unheard);
        if (auto* control = controls.find(program, without)) control->varies = true;
    };
}

// The scene with programs for other sets of values.
struct Compared {
    std::vector<std::unique_ptr<Document>> documents;  // which share what they can with the scene
    std::vector<Comparison> comparisons;
};

// With programs for any values, and for all values but one that switches something off; as many as there is time for.
Compared compare(ExplainReport& report, const Document& document, const ExplainOptions& options, const Frame& frame,
                 const Surface& surface, const Running& running) {
    Compared compared;
    const double until = running.watch.milliseconds() + .5 * time_left(options, running);
    const auto add = [&](std::function<void(Controls&, const Scene&)> settle, std::optional<FrameCost>& saved) {
        if (running.watch.milliseconds() > until) return;
        running.deadline.now(fmt::format("drawing '{}' with programs for other values", options.scene));
        Diagnostics unheard;
        const RuntimeOptions how{.previous = &*document.runtime, .settle = std::move(settle)};
        auto other =
            open_document(options.scene, report.caps, rungs_of(options, unheard), nullptr, how, options.access);
        if (!other->runtime) return;
        other->runtime->draw(frame, surface);
        gl::finish();
        compared.comparisons.push_back({&*other->runtime, &saved});
        compared.documents.push_back(std::move(other));
    };
    auto& rows = report.explanation.switched_off;
    if (!rows.empty()) add(nullptr, report.saved);
    for (auto& row : rows)
        if (!row.uniform.empty()) add(values_of(options, row.program, row.uniform), row.saved);
    return compared;
}

// `took`: milliseconds of a frame.
void time_all(ExplainReport& report, Document& document, const ExplainOptions& options, const Frame& frame,
              const Surface& surface, double took, const Running& running) {
    const Compared compared = compare(report, document, options, frame, surface, running);
    running.progress.begin();
    time_frames(report, *document.runtime, frame, surface,
                {options.rounds, time_left(options, running), took,
                 [&](int round, double share) {
                     running.progress.show(fmt::format("timing frames: round {} of {}", round + 1, options.rounds),
                                           share);
                 }},
                compared.comparisons);
    running.progress.clear();
    if (report.clock.empty())
        fmt::print(stderr,
                   "snell: warning: frames are not timed: one takes {:.1f} s\n   help: take a smaller --size or a "
                   "longer --timeout\n",
                   took / 1e3);
}

using accuracy::FoundResult, accuracy::FoundRung;

// What the rung saves of a frame: the median of the differences to frames of the scene.
std::optional<FrameCost> saved_by(const FoundRung& rung, const FoundResult& result) {
    const accuracy::RungResult* without = result.times(rung);
    if (!without || result.costs.rungs.empty()) return std::nullopt;
    const accuracy::RungResult& with = result.costs.rungs.back();
    const auto median = [&](const std::vector<double>& a, const std::vector<double>& b) {
        std::vector<double> differences;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            if (a[i] > 0 && b[i] > 0) differences.push_back(a[i] - b[i]);
        return accuracy::median(differences);
    };
    FrameCost cost{median(with.cpu, without->cpu), median(with.wall, without->wall), std::nullopt};
    if (std::isnan(cost.wall)) return std::nullopt;  // they have no round in common
    if (result.costs.clock == accuracy::ClockKind::gpu) cost.gpu = median(with.gpu, without->gpu);
    return cost;
}

// What may be left out, by its number among all changes of the scene.
struct Omissions {
    std::vector<accuracy::Change> changes;
    std::vector<std::size_t> numbers;
};

Omissions omissions_of(const Plan& plan, Document& document) {
    Omissions omissions;
    const auto all = accuracy::find_changes(plan, *document.files, document.sources);
    for (std::size_t i = 0; i < all.size(); ++i)
        if (accuracy::facts(all[i].kind).aim == accuracy::Aim::unused) {
            omissions.changes.push_back(all[i]);
            omissions.numbers.push_back(i + 1);
        }
    return omissions;
}

// The most expensive first.
WithoutEffect without_effect(const FoundResult& result, const Omissions& omissions, bool software) {
    const auto tried = ranges::count(result.rungs, accuracy::Outcome::tried, &FoundRung::outcome);
    WithoutEffect found{.cannot_say = result.cannot_say,
                        .rows = {},
                        .tried = static_cast<std::size_t>(tried),
                        .places = result.places.size(),
                        .held_out = result.places.size() - std::min(result.searched, result.places.size()),
                        .late = result.late};
    for (const FoundRung* rung : result.without_effect()) {
        const std::size_t change = rung->changes.front();
        found.rows.push_back({std::to_string(omissions.numbers[change]), result.positions[change],
                              omissions.changes[change].before, saved_by(*rung, result), rung->gpu_bytes,
                              rung->bytes_decoded, rung->load_ms});
    }
    const auto costs = [&](const WithoutEffect::Row& row) {
        return std::pair(row.frame ? shown(*row.frame, software) : 0, row.gpu_bytes);
    };
    std::stable_sort(found.rows.begin(), found.rows.end(),
                     [&](const auto& a, const auto& b) { return costs(a) > costs(b); });
    return found;
}

// Leaves out one thing after the other. `plan` has the chosen rungs.
WithoutEffect find_without_effect(const ExplainReport& report, const Plan& plan, Document& document,
                                  const ExplainOptions& options, const Running& running) {
    const Omissions omissions = omissions_of(plan, document);
    if (omissions.changes.empty()) return {};
    accuracy::SearchOptions how;
    how.seconds = .5e-3 * time_left(options, running);
    how.rounds = options.rounds;
    how.times = !options.no_time;
    how.report = [&](const accuracy::Progress& progress) {
        running.deadline.now(fmt::format("drawing '{}' without some of it", options.scene));
        running.progress.show("leaving out what may have no effect", progress.done);
    };
    running.progress.begin();
    const accuracy::BenchSettings settings{report.width, report.height, options.time, options.sets, options.specialise};
    accuracy::Search search({options.scene, plan, *document.files, document.sources}, omissions.changes, report.caps,
                            settings, how);
    while (search.step()) continue;
    running.progress.clear();
    return without_effect(search.result(), omissions, report.caps.software);
}

// Draws two frames and counts, then times frames for as long as there is time.
void measure(ExplainReport& report, Document& document, const Plan& plan, const ExplainOptions& options,
             const Running& running) {
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
    const double until = running.watch.milliseconds() + .25 * time_left(options, running);
    while (running.watch.milliseconds() < until && runtime.find_switched_off()) continue;
    report.explanation = runtime.explain();
    if (options.without_effect) report.without_effect = find_without_effect(report, plan, document, options, running);
    if (!options.no_time) time_all(report, document, options, frame, surface, took, running);
}

Exit explain(const ExplainOptions& options) {
    const runtime::Stopwatch watch;
    Deadline deadline(options.timeout);
    deadline.begin(fmt::format("reading '{}'", options.scene));
    const std::array outputs{options.json};
    if (const Exit refused = check_outputs(outputs, read_by(std::array{options.scene}, outputs, options.access));
        refused != exit_fine)
        return refused;
    auto context = headless_context(options.context);
    if (!context) return exit_graphics;
    ExplainReport report;
    report.scene = options.scene;
    report.caps = gl::query_caps();
    Diagnostics chosen;
    ProgressLine progress;
    RuntimeOptions how{.progress = progress.watcher()};
    if (options.specialise) how.settle = values_of(options);
    Plan planned;
    const auto document = open_document(
        options.scene, report.caps, rungs_of(options, chosen),
        [&](const Plan& plan, Document& opened) {
            report.lints = lint::check(plan, opened.sources, shader_includes(*opened.files));
            if (options.without_effect) planned = plan;
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
    measure(report, *document, planned, options, {watch, deadline, progress});
    deadline.rest();
    const std::string text =
        options.json.empty() ? explain_text(report, document->sources) : explain_json(report, document->sources);
    if (options.json.empty())
        std::fwrite(text.data(), 1, text.size(), stdout);
    else if (!write_output(options.json, text))
        return exit_input;
    return errors.has_errors() ? exit_input : exit_fine;
}

}  // namespace

Run add_explain(CLI::App& command) {
    auto options = std::make_shared<ExplainOptions>();
    add_access(command, options->access);
    add_timeout(command, options->timeout, "all of it; expensive frames are timed in fewer rounds");
    command.footer("Times are of this machine, now; those of passes are by difference.");
    command.add_option("SCENE", options->scene)->required();
    add_json(command, options->json, "print JSON");
    command.add_flag("--no-time", options->no_time, "do not time frames");
    command.add_flag("--without-effect", options->without_effect,
                     "leave out draws, textures, uniforms and statements, to find those that change no pixel");
    command.add_option("--reps", options->rounds, "rounds, in each of which every pass is left out once")
        ->check(CLI::Range(3, 10000));
    add_size(command, options->size, "WIDTHxHEIGHT (default: the scene's)");
    add_time(command, options->time);
    add_values(command, options->sets, options->ladders);
    add_specialise(command, options->specialise);
    add_context(command, options->context);
    return [options] { return size_fits(options->size, options->access.limits) ? explain(*options) : exit_usage; };
}

// Times frames, frames without some of their draws, and frames of other programs.

namespace {

using Paid = Explanation::Paid;

// Times frames of which some draws are left out.
class Rounds {
public:
    Rounds(const Frame& frame, const Surface& surface, bool software)
        : frame_(frame), surface_(surface), software_(software) {}

    FrameCost once(Runtime& runtime, const std::vector<bool>& hidden = {}, int frames = 1) {
        Frame frame = frame_;
        frame.hidden = hidden.empty() ? nullptr : &hidden;
        gl::finish();
        const bool query = !software_ && query_.available();
        if (query) query_.begin();
        const double cpu = accuracy::cpu_milliseconds();
        const runtime::Stopwatch watch;
        for (int i = 0; i < frames; ++i) {
            runtime.draw(frame, surface_);
            gl::finish();
        }
        FrameCost cost{(accuracy::cpu_milliseconds() - cpu) / frames, watch.milliseconds() / frames, std::nullopt};
        if (query) cost.gpu = query_.end() / frames;
        return cost;
    }

    // A timer query is trusted if it agrees with the wall clock on a heavy load.
    bool calibrated(Runtime& runtime) {
        if (software_ || !query_.available()) return false;
        const int frames = std::clamp(static_cast<int>(200 / std::max(once(runtime).wall, .01)), 1, 1000);
        const FrameCost heavy = once(runtime, {}, frames);
        return heavy.gpu && *heavy.gpu > .8 * heavy.wall && *heavy.gpu < 1.2 * heavy.wall;
    }

private:
    Frame frame_;
    Surface surface_;
    bool software_;
    gl::TimerQuery query_;
};

// Compares times of the same rounds; the last round may be incomplete.
FrameCost median_difference(const std::vector<FrameCost>& with, const std::vector<FrameCost>& without, bool gpu) {
    const auto median = [&](auto value) {
        std::vector<double> differences;
        for (std::size_t i = 0; i < std::min(with.size(), without.size()); ++i)
            differences.push_back(value(with[i]) - value(without[i]));
        return accuracy::median(differences);
    };
    FrameCost cost{median([](const FrameCost& c) { return c.cpu; }), median([](const FrameCost& c) { return c.wall; }),
                   std::nullopt};
    if (gpu) cost.gpu = median([](const FrameCost& c) { return c.gpu.value_or(0); });
    return cost;
}

// What is timed in turns with the whole frame, and where the difference goes.
struct Timed {
    Runtime* runtime;
    std::vector<bool> hidden;  // as Frame::hidden
    std::optional<FrameCost>* result;
    bool more;  // it takes what the whole frame takes, and more
    std::vector<FrameCost> costs = {};
};

// Cube passes that are kept are not among the parts: they would be drawn only because their draws come and go.
std::vector<Timed> timed_parts(Explanation& explanation, Runtime& runtime, std::span<const Comparison> comparisons) {
    std::vector<Timed> parts;
    std::set<Index> kept;
    for (const Paid& paid : explanation.paid)
        if (paid.kept) kept.insert(paid.draws.begin(), paid.draws.end());
    for (Paid& paid : explanation.paid) {
        if (paid.draws.empty() || ranges::any_of(paid.draws, [&](Index draw) { return kept.contains(draw); })) continue;
        std::vector<bool> hidden(runtime.scene().draws.size(), false);
        for (const Index draw : paid.draws) hidden[draw] = true;
        parts.push_back({&runtime, std::move(hidden), &paid.frame, false});
    }
    for (const Comparison& comparison : comparisons) parts.push_back({comparison.runtime, {}, comparison.saved, true});
    return parts;
}

}  // namespace

double shown(const FrameCost& cost, bool software) { return cost.gpu ? *cost.gpu : software ? cost.cpu : cost.wall; }

void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing, std::span<const Comparison> comparisons) {
    const runtime::Stopwatch watch;
    Rounds clock(frame, surface, report.caps.software);
    std::vector<Timed> parts = timed_parts(report.explanation, runtime, comparisons);
    const bool gpu = clock.calibrated(runtime);
    std::vector<FrameCost> whole;
    double longest = timing.frame;
    const auto fits = [&] { return watch.milliseconds() + longest < timing.milliseconds; };
    const auto timed = [&](Runtime& of, const std::vector<bool>& hidden) {
        const double share = std::max(watch.milliseconds() / std::max(timing.milliseconds, 1.),
                                      static_cast<double>(whole.size()) / static_cast<double>(timing.rounds));
        if (timing.report) timing.report(static_cast<int>(whole.size()), share);
        const FrameCost cost = clock.once(of, hidden);
        longest = std::max(longest, cost.wall);
        return cost;
    };
    for (int round = 0; round < timing.rounds && fits(); ++round) {
        whole.push_back(timed(runtime, {}));
        for (std::size_t i = 0; i < parts.size() && fits(); ++i)
            parts[i].costs.push_back(timed(*parts[i].runtime, parts[i].hidden));
    }
    if (whole.empty()) return;
    report.asked = timing.rounds;
    report.rounds = static_cast<int>(whole.size());
    report.clock = gpu                    ? "timer queries of the GPU"
                   : report.caps.software ? "CPU time of the process"
                                          : "the wall's clock";
    report.frame = median_difference(whole, std::vector<FrameCost>(whole.size()), gpu);
    for (const Timed& part : parts)
        if (!part.costs.empty())
            *part.result =
                part.more ? median_difference(part.costs, whole, gpu) : median_difference(whole, part.costs, gpu);
    std::vector<double> values;
    for (FrameCost& cost : whole) {
        if (!gpu) cost.gpu.reset();
        values.push_back(shown(cost, report.caps.software));
    }
    report.spread = accuracy::mad(values);
}

}  // namespace snell::app
