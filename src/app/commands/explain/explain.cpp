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
#include "src/accuracy/timing.h"
#include "src/app/commands/options.h"
#include "src/app/commands/subcommands.h"
#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/app/open/headless.h"
#include "src/app/open/progress.h"
#include "src/app/picture/outputs.h"
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

// The scene with programs for any values, and for all values but one that switches something off; as many as there is
// time for. They share what they can with the scene.
std::vector<Comparison> compare(ExplainReport& report, const Document& document, const ExplainOptions& options,
                                const Frame& frame, const Surface& surface, const Running& running) {
    std::vector<Comparison> compared;
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
        compared.push_back({std::move(other), &saved});
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
    const std::vector<Comparison> compared = compare(report, document, options, frame, surface, running);
    running.progress.begin();
    time_frames(report, *document.runtime, frame, surface,
                {options.rounds, time_left(options, running), took,
                 [&](int round, double share) {
                     running.progress.show(fmt::format("timing frames: round {} of {}", round + 1, options.rounds),
                                           share);
                 }},
                compared);
    running.progress.clear();
    if (report.clock.empty())
        fmt::print(stderr,
                   "snell: warning: frames are not timed: one takes {:.1f} s\n   help: take a smaller --size or a "
                   "longer --timeout\n",
                   took / 1e3);
}

using accuracy::FoundResult, accuracy::FoundRung;

// Milliseconds by each clock, of which that of the GPU counts only if it is the right one; nullopt: not known.
template <class Milliseconds>
std::optional<FrameCost> cost_by(accuracy::ClockKind clock, const Milliseconds& by) {
    using accuracy::ClockKind;
    FrameCost cost{by(ClockKind::cpu), by(ClockKind::wall), std::nullopt};
    if (std::isnan(cost.wall)) return std::nullopt;
    if (clock == ClockKind::gpu) cost.gpu = by(clock);
    return cost;
}

// What the rung saves of a frame.
std::optional<FrameCost> saved_by(const FoundRung& rung, const FoundResult& result) {
    const accuracy::RungResult* without = result.times(rung);
    if (!without || result.costs.rungs.empty()) return std::nullopt;
    const accuracy::RungResult& with = result.costs.rungs.back();
    return cost_by(result.costs.clock, [&](accuracy::ClockKind clock) {
        return accuracy::paired_difference(with.times(clock), without->times(clock));
    });
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
    const Diagnostics errors = errors_of(document->diagnostics);
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

// What is timed in turns, and where its difference to the whole frame goes.
struct Timed {
    Runtime* runtime;
    std::vector<bool> hidden = {};  // as Frame::hidden
    std::optional<FrameCost>* result = nullptr;
    bool more = false;  // it takes what the whole frame takes, and more
};

// The whole frame first. Cube passes that are kept are not among the parts: they would be drawn only because their
// draws come and go.
std::vector<Timed> timed_parts(Explanation& explanation, Runtime& runtime, std::span<const Comparison> comparisons) {
    std::vector<Timed> parts{{&runtime}};
    std::set<Index> kept;
    for (const Paid& paid : explanation.paid)
        if (paid.kept) kept.insert(paid.draws.begin(), paid.draws.end());
    for (Paid& paid : explanation.paid) {
        if (paid.draws.empty() || ranges::any_of(paid.draws, [&](Index draw) { return kept.contains(draw); })) continue;
        std::vector<bool> hidden(runtime.scene().draws.size(), false);
        for (const Index draw : paid.draws) hidden[draw] = true;
        parts.push_back({&runtime, std::move(hidden), &paid.frame, false});
    }
    for (const Comparison& comparison : comparisons)
        parts.push_back({&*comparison.document->runtime, {}, comparison.saved, true});
    return parts;
}

}  // namespace

double shown(const FrameCost& cost, bool software) { return cost.gpu ? *cost.gpu : software ? cost.cpu : cost.wall; }

void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing, std::span<const Comparison> comparisons) {
    const runtime::Stopwatch watch;
    accuracy::FrameClock timer(report.caps.software);
    const accuracy::ClockKind kind = timer.choose([&] { runtime.draw(frame, surface); });
    double longest = timing.frame;
    const std::vector<Timed> parts = timed_parts(report.explanation, runtime, comparisons);
    std::vector<accuracy::Entrant> entrants;
    for (const Timed& part : parts)
        entrants.push_back({[&](accuracy::ClockKind) { return timing.frame; },  // all were drawn before
                            [&](double) {
                                Frame less = frame;
                                less.hidden = part.hidden.empty() ? nullptr : &part.hidden;
                                const accuracy::Times took = timer.of([&] { part.runtime->draw(less, surface); });
                                longest = std::max(longest, took.wall);
                                return took;
                            }});
    accuracy::Rounds rounds(std::move(entrants),
                            {.clock = kind,
                             .control = false,
                             .rounds = timing.rounds,
                             .at_least = 0,
                             .stopped = [&] { return watch.milliseconds() + longest >= timing.milliseconds; },
                             .report =
                                 [&](std::string_view doing, double done) {
                                     if (!timing.report || doing != "timing") return;
                                     timing.report(
                                         static_cast<int>(std::lround(done * timing.rounds)),
                                         std::max(watch.milliseconds() / std::max(timing.milliseconds, 1.), done));
                                 }});
    rounds.run();
    const auto by = [&](std::size_t part, accuracy::ClockKind clock) {
        return accuracy::by_clock(rounds.times(part), clock);
    };
    const std::vector<double> whole = accuracy::taken(by(0, kind));
    if (whole.empty()) return;
    report.asked = timing.rounds;
    report.rounds = static_cast<int>(whole.size());
    report.clock = kind == accuracy::ClockKind::gpu   ? "timer queries of the GPU"
                   : kind == accuracy::ClockKind::cpu ? "CPU time of the process"
                                                      : "the wall's clock";
    report.frame =
        *cost_by(kind, [&](accuracy::ClockKind clock) { return accuracy::median(accuracy::taken(by(0, clock))); });
    report.spread = accuracy::mad(whole);
    for (std::size_t i = 1; i < parts.size(); ++i)
        *parts[i].result = cost_by(kind, [&](accuracy::ClockKind clock) {
            const std::size_t more = parts[i].more ? i : 0;
            return accuracy::paired_difference(by(more, clock), by(i - more, clock));
        });
}

}  // namespace snell::app
