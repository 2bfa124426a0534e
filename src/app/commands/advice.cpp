#include "src/app/commands/advice.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/advice.h"
#include "src/accuracy/report/quality.h"
#include "src/app/commands/options.h"
#include "src/app/open/command_text.h"
#include "src/app/open/quality.h"
#include "src/app/open/write_copy.h"
#include "src/document/document.h"

namespace snell::app {

namespace {

using namespace snell::accuracy;

std::string found_text(const Advice& advice, const SweepResult& sweep) {
    const RungResult& rung = sweep.rungs[advice.rung];
    const std::string now = sweep.rungs[sweep.sweep.current].name;
    std::string text = content::paragraph(fmt::format("RMSE {:.3g}{}, {} '{}' takes", rung.own.light.rmse,
                                                      residual_text(sweep, advice.wish), cost_text(rung, sweep), now),
                                          2);
    text += content::paragraph(fmt::format("{}; the last rungs at the scene's own samples and meshes: RMSE {:.3g}",
                                           sweep.reference_note, sweep.rungs[sweep.sweep.reference].own.light.rmse),
                               2);
    const char* what = advice.everything ? "every combination" : "every combination that differs in one ladder";
    text += advice.settled ? fmt::format("  {} was measured, none is better\n", what)
            : sweep.few_rounds
                ? "  there were too few rounds to be sure: others may be better; more --budget or --reps tells\n"
                : "  time was up: others may be better; more --budget tells\n";
    if (const std::string noise = noise_sentence(sweep.control); !noise.empty() && !sweep.few_rounds)
        text += content::paragraph(noise, 2);
    return text;
}

// The command that draws what was measured: in the same size, at the same time and with the same values.
std::string render_line(const Bench& bench, const std::string& path, const std::vector<std::string>& rungs) {
    const BenchSettings& how = bench.settings();
    std::string line = "snell render " + file_word(path) + " -o picture.png";
    if (std::array{how.width, how.height} != bench.scene().window_size)
        line += fmt::format(" --size {}x{}", how.width, how.height);
    if (how.time != 0) line += fmt::format(" --time {}", how.time);
    for (const std::string& set : how.sets) line += " --set " + shell_word(set);
    for (const std::string& rung : rungs) line += " --ladder " + shell_word(rung);
    return line;
}

std::string advice_text(const std::string& path, const Bench& bench, const Advice& advice, const SweepResult& sweep) {
    if (!advice.known)
        return "\n" + content::paragraph(fmt::format("{}: can't say: {}", wish_text(advice.wish),
                                                     sweep.cannot_say.empty()
                                                         ? "no combination was drawn and timed with a finite error"
                                                         : sweep.cannot_say),
                                         0);
    const std::vector<std::string> rungs = choices(bench.scene(), sweep.sweep.rungs[advice.rung].variant.rungs);
    const char* kind = !advice.wish.milliseconds ? "the cheapest" : "the most exact";
    const bool perhaps = advice.wish.milliseconds && sweep.rungs[advice.rung].milliseconds <= *advice.wish.milliseconds;
    const std::string answer = advice.met ? fmt::format("{} is", kind)
                               : perhaps  ? "nothing that was measured surely is; the nearest is"
                                          : "nothing that was measured is; the nearest is";
    return "\n" +
           content::paragraph(fmt::format("{}: {} {}", wish_text(advice.wish), answer, fmt::join(rungs, " ")), 0) +
           found_text(advice, sweep) + "  " + render_line(bench, path, rungs) + "\n";
}

bool save_presets(const std::string& path, const Scene& scene, const Counsel& counsel, const Circumstances& where) {
    if (!ranges::all_of(counsel.advice, &Advice::known))
        return complain(fmt::format("there are no presets for '{}': nothing can be said of its rungs", path));
    const std::vector<Preset> presets = presets_of(scene, counsel);
    const std::string file = quality_path(path);
    if (!write_output(file, quality_json(where, presets))) return false;
    fmt::print("\npresets for --quality, in {}\n", utf8::printable(file));
    for (const Preset& preset : presets)
        fmt::print("  {:<8}  {}: RMSE {:.2g}, {:.2g} from the last rungs, {} times\n", preset.name,
                   fmt::join(preset.choices, " "), preset.rmse, preset.alone, ratio_text(preset.ratio));
    return true;
}

// False, if no limit is met. `saved`: the presets were written, if they were wanted.
bool advise_ladders(const AccuracyOptions& options, const std::string& path, Bench& bench, const Rungs& now,
                    const MeasureOptions& measuring, Report& report, bool& saved) {
    std::vector<Wish> wishes;
    if (options.save_quality) ranges::copy(quality_wishes(), std::back_inserter(wishes));
    if (options.within || options.error) wishes.push_back({options.within, options.error});
    Counsel counsel = advise(bench, now, wishes, measuring);
    for (SweepResult& sweep : counsel.sweeps) {
        sweep.scene = path;
        fmt::print("{}", table_text(sweep));
    }
    bool met = true;
    if (options.within || options.error) {
        const Advice& advice = counsel.advice.back();
        met = advice.met;
        fmt::print("{}", advice_text(path, bench, advice, counsel.sweeps[advice.sweep]));
        counsel.advice.pop_back();
    }
    saved = !options.save_quality || save_presets(path, bench.scene(), counsel, report.where);
    for (SweepResult& sweep : counsel.sweeps) report.sweeps.push_back(std::move(sweep));
    return met;
}

// Whether a rung of the knob is what was wished for; prints it.
bool tell_knob(const SweepResult& result, const Wish& wish) {
    const auto best = result.few_rounds ? std::nullopt : choose(result, wish);
    if (!best || !fulfils(result, result.rungs[*best], wish)) return false;
    const RungResult& rung = result.rungs[*best];
    fmt::print("\n{}  RMSE {:.3g}{}, {} times\n",
               content::paragraph(
                   fmt::format("{}: of the knob {} it is '{}'", wish_text(wish), result.sweep.name, rung.name), 0),
               rung.own.light.rmse,
               wish.error && result.residual != 0 ? residual_text(result, wish) : " from the reference",
               ratio_text(rung.ratio));
    return true;
}

// Of the knobs that the options name, which were measured already.
bool advise_named_knobs(const std::string& path, const Wish& wish, const Report& report) {
    bool met = false;
    for (const SweepResult& result : report.sweeps)
        if (result.scene == path) met = tell_knob(result, wish) || met;
    if (!met) fmt::print("\n{}: no rung of these knobs is known to be; others were not tried\n", wish_text(wish));
    return met;
}

// Each knob alone, as they change what no ladder does.
bool advise_knobs(const std::string& path, Bench& bench, const Rungs& now, const Wish& wish,
                  const MeasureOptions& measuring, Report& report) {
    Diagnostics unheard;  // no name was given that could be wrong
    const std::vector<std::string> names(knob_names.begin(), knob_names.end());
    const auto sweeps = knob_sweeps(bench.scene(), now, names, From::reference, gl::query_caps().software, unheard);
    bool met = false;
    for (const Sweep& sweep : sweeps) {
        MeasureOptions one = measuring;
        one.seconds = measuring.seconds / static_cast<double>(sweeps.size());
        if (measuring.stop && measuring.stop()) break;
        SweepResult result = measure(bench, sweep, one);
        result.scene = path;
        fmt::print("{}", table_text(result));
        met = tell_knob(result, wish) || met;
        report.sweeps.push_back(std::move(result));
    }
    return met;
}

constexpr std::string_view from_scene = "the scene as it is";

// What `choose` takes of the rungs that were found; the last one is the scene as it is.
std::string found_choice_text(const std::string& path, const AccuracyOptions& options, const FoundResult& found,
                              std::size_t best) {
    const RungResult& rung = found.timed.rungs[best];
    if (best == found.timed.sweep.current) return fmt::format("{}, {}\n", from_scene, time_text(rung));
    return fmt::format(
        "found rung {} ({})\n{}  {}\n", utf8::printable(rung.name), rung_name(rung.steps),
        content::paragraph(
            fmt::format("RMSE {:.3g} from {}, at the worst of {} places; {} the scene takes", rung.own.light.rmse,
                        from_scene, found.places.size(), cost_text(rung, found.timed)),
            2),
        apply_command(path, options.choices, rung_name(rung.steps), "FOLDER"));
}

// The scene as it is has no error from itself, so it is an answer to a limit of time only, and of a scene without
// ladders only: these are judged by the reference.
bool advise_found(const std::string& path, const AccuracyOptions& options, const FoundResult& found, const Wish& wish,
                  bool ladders) {
    const std::string wished = wish_text(wish, from_scene);
    const auto best = choose_surely(found.timed, wish);
    if (!best) {
        fmt::print("\n{}: can't say of found rungs: none was timed\n", wished);
        return false;
    }
    const bool met = fulfils(found.timed, found.timed.rungs[*best], wish);
    if (*best == found.timed.sweep.current && (ladders || wish.error)) {
        fmt::print("\n{}", content::paragraph(fmt::format("{}: no found rung is known to be better than the scene, {}",
                                                          wished, time_text(found.timed.rungs[*best])),
                                              0));
        return false;
    }
    fmt::print("\n{}: {} {}", wished,
               !met                ? "no found rung is; the nearest is"
               : wish.milliseconds ? "the most exact is"
                                   : "the cheapest is",
               found_choice_text(path, options, found, *best));
    if (found.timed.few_rounds) fmt::print("  the costs are not sure: there were too few rounds\n");
    return met;
}

// A preset names rungs of ladders, so a scene without ladders has none: what would be in it, and how to get there.
bool explain_presets(const std::string& path, const AccuracyOptions& options, const FoundResult* found) {
    complain(
        fmt::format("'{}' has no ladders, so no presets were written: a preset names a rung of each ladder", path));
    if (!found) return false;
    const std::array<Wish, 3> wishes = quality_wishes();
    for (std::size_t i = 0; i < wishes.size(); ++i)
        if (const auto best = choose(found->timed, wishes[i]))
            fmt::print("{}{:<8}  {}", i == 0 ? "\nof the found rungs these would be\n" : "", quality_names[i],
                       found_choice_text(path, options, *found, *best));
    return false;
}

std::string check_milliseconds(const std::string& text) {
    return parse_milliseconds(text) ? "" : "'" + text + "' is not a time such as 16ms";
}

}  // namespace

bool asks_for_advice(const AccuracyOptions& options) { return options.within || options.error || options.save_quality; }

std::optional<double> parse_milliseconds(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const std::string unit = end;
    if (end == text.c_str() || !std::isfinite(value) || value <= 0) return std::nullopt;
    if (unit.empty() || unit == "ms") return value;
    return unit == "s" ? std::optional(1e3 * value) : std::nullopt;
}

void add_advice(CLI::App& command, AccuracyOptions& options, CLI::Option& untimed) {
    command
        .add_option_function<std::string>(
            "--within", [&options](const std::string& text) { options.within = parse_milliseconds(text); },
            "find the most accurate combination that takes no longer, such as 16ms")
        ->check(check_milliseconds)
        ->excludes(&untimed);
    command.add_option("--error", options.error, "find the cheapest combination with no more RMSE of light")
        ->check(check_finite_number)
        ->check(CLI::Range(0., 1e6))
        ->excludes(&untimed);
    command.add_flag("--save-quality", options.save_quality, "find presets for --quality, stored next to the scene")
        ->excludes(&untimed);
}

bool give_advice(const AccuracyOptions& options, const std::string& path, Bench& bench, const Rungs& now,
                 const MeasureOptions& measuring, const FoundResult* found, Report& report) {
    const bool limited = options.within || options.error;
    const Wish wish{options.within, options.error};
    bool met = false, saved = true;
    const bool ladders = !bench.scene().ladders.empty();
    if (ladders) {
        met = advise_ladders(options, path, bench, now, measuring, report, saved);
    } else {
        saved = !options.save_quality || explain_presets(path, options, found);
        if (limited)
            met = options.knobs.empty() ? advise_knobs(path, bench, now, wish, measuring, report)
                                        : advise_named_knobs(path, wish, report);
    }
    if (limited && found) met = advise_found(path, options, *found, wish, ladders) || met;
    return saved && (met || !limited);
}

}  // namespace snell::app
