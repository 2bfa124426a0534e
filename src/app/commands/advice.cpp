#include "src/app/commands/advice.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "src/accuracy/found/together.h"
#include "src/accuracy/report/quality.h"
#include "src/app/open/command_text.h"
#include "src/app/open/complain.h"
#include "src/app/open/quality.h"

namespace snell::app {

namespace {

using namespace snell::accuracy;

std::string wish_text(const Wish& wish) {
    std::string text;
    if (wish.error) text = fmt::format("RMSE of light at most {:.3g}", *wish.error);
    if (wish.milliseconds) text += fmt::format("{}at most {:.3g} ms", text.empty() ? "" : " and ", *wish.milliseconds);
    return text.empty() ? "whatever its error is" : text;
}

// What is added to an error when it is compared with a limit.
std::string residual_text(const SweepResult& sweep, const Wish& wish) {
    if (!wish.error || sweep.residual == 0) return "";
    return sweep.residual ? fmt::format(" and up to {:.2g} of the reference", *sweep.residual)
                          : " and an unknown part of the reference";
}

// What a rung takes, with the interval of the median.
std::string time_text(const RungResult& rung) {
    return fmt::format("{:.3g} ms [{:.3g}, {:.3g}]", rung.milliseconds, rung.low, rung.high);
}

std::string cost_text(const RungResult& rung, const SweepResult& sweep) {
    return fmt::format("{} of {}, {} times what", time_text(rung), name(sweep.clock), ratio_text(rung.ratio));
}

std::string found_text(const Advice& advice, const SweepResult& sweep) {
    const RungResult& rung = sweep.rungs[advice.rung];
    const std::string now = sweep.rungs[sweep.sweep.current].name;
    std::string text = fmt::format("  RMSE {:.3g}{}, {} '{}' takes\n", rung.own.light.rmse,
                                   residual_text(sweep, advice.wish), cost_text(rung, sweep), now);
    text += fmt::format("  {}; the last rungs at the scene's own samples and meshes: RMSE {:.3g}\n",
                        sweep.reference_note, sweep.rungs[sweep.sweep.reference].own.light.rmse);
    const char* what = advice.everything ? "every combination" : "every combination that differs in one ladder";
    text += advice.settled ? fmt::format("  {} was measured, none is better\n", what)
                           : std::string("  time was up: others may be better; more --budget tells\n");
    if (!sweep.few_rounds && sweep.control.noisy)
        text += fmt::format("  the machine is too noisy to be sure of costs: '{}' took {} times what it took itself\n",
                            now, ratio_text(sweep.control.ratio));
    return text;
}

std::string advice_text(const std::string& path, const Scene& scene, const Advice& advice, const SweepResult& sweep) {
    if (!advice.known)
        return fmt::format(
            "\n{}: can't say: {}\n", wish_text(advice.wish),
            sweep.cannot_say.empty() ? "no combination was drawn and timed with a finite error" : sweep.cannot_say);
    const std::vector<std::string> rungs = choices(scene, sweep.sweep.rungs[advice.rung].variant.rungs);
    const char* kind = !advice.wish.milliseconds ? "the cheapest" : "the most exact";
    std::string text = advice.met ? fmt::format("\n{}: {} is {}\n", wish_text(advice.wish), kind, fmt::join(rungs, " "))
                                  : fmt::format("\n{}: nothing that was measured is; the nearest is {}\n",
                                                wish_text(advice.wish), fmt::join(rungs, " "));
    text += found_text(advice, sweep) + "  snell render " + file_word(path) + " -o picture.png";
    for (const std::string& choice : rungs) text += " --ladder " + choice;
    return text + "\n";
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
        fmt::print("{}", advice_text(path, bench.scene(), advice, counsel.sweeps[advice.sweep]));
        counsel.advice.pop_back();
    }
    saved = !options.save_quality || save_presets(path, bench.scene(), counsel, report.where);
    for (SweepResult& sweep : counsel.sweeps) report.sweeps.push_back(std::move(sweep));
    return met;
}

// Whether a rung of the knob is what was wished for; prints it.
bool tell_knob(const SweepResult& result, const Wish& wish) {
    const auto best = choose(result, wish);
    if (!best || !fulfils(result, result.rungs[*best], wish)) return false;
    const RungResult& rung = result.rungs[*best];
    fmt::print("\n{}: of the knob {} it is '{}'\n  RMSE {:.3g}{}, {} times\n", wish_text(wish), result.sweep.name,
               rung.name, rung.own.light.rmse,
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

// What `choose` takes of the rungs that were found; the last one is the scene as it is.
std::string found_choice_text(const std::string& path, const AccuracyOptions& options, const FoundResult& found,
                              std::size_t best) {
    const RungResult& rung = found.timed.rungs[best];
    if (best == found.timed.sweep.current) return fmt::format("the scene as it is, {}\n", time_text(rung));
    return fmt::format(
        "found rung {}\n  RMSE {:.3g} from the scene as it is, at the worst of {} places; {} the scene takes\n  {}\n",
        rung.name, rung.own.light.rmse, found.places.size(), cost_text(rung, found.timed),
        apply_command(path, options.choices, rung.name, "FOLDER"));
}

// False, too, if it is the scene as it is: ladders are judged by the reference, not by what the scene has.
bool advise_found(const std::string& path, const AccuracyOptions& options, const FoundResult& found, const Wish& wish,
                  bool ladders) {
    const auto best = choose_surely(found.timed, wish);
    if (!best) {
        fmt::print("\n{}: can't say of found rungs: none was timed\n", wish_text(wish));
        return false;
    }
    const bool met = fulfils(found.timed, found.timed.rungs[*best], wish);
    fmt::print("\n{}: {} {}", wish_text(wish),
               !met                ? "no found rung is; the nearest is"
               : wish.milliseconds ? "the most exact is"
                                   : "the cheapest is",
               found_choice_text(path, options, found, *best));
    if (found.timed.few_rounds || found.timed.control.noisy)
        fmt::print("  the costs are not sure: {}\n",
                   found.timed.few_rounds ? "there were too few rounds" : "the machine is too noisy");
    return met && !(ladders && *best == found.timed.sweep.current);
}

// All kinds together. False, if no limit is met.
bool advise_mixed(const std::string& path, const AccuracyOptions& options, Bench& bench, const Sought& sought,
                  const Wish& wish, const MeasureOptions& measuring, const Report& report) {
    MixOptions how{.rungs = {}, .measuring = measuring};
    for (const SweepResult& sweep : report.sweeps) {
        if (sweep.scene != path || sweep.sweep.kind != SweepKind::lattice) continue;
        if (const auto best = choose(sweep, wish)) how.rungs.push_back(sweep.sweep.rungs[*best].variant.rungs);
    }
    const MixAdvice advice =
        advise_together(sought.original, sought.found, bench, sought.caps, sought.settings, wish, how);
    if (!advice.best) {
        fmt::print("\n{}: of everything together, can't say: the time was up\n", wish_text(wish));
        return false;
    }
    const SweepResult& sweep = advice.sweep;
    const RungResult& rung = sweep.rungs[*advice.best];
    const Mix& mix = advice.mixes[*advice.best];
    fmt::print("{}\n{}: of everything together {} '{}'\n", table_text(sweep), wish_text(wish),
               !advice.met         ? "nothing that was measured is; the nearest is"
               : wish.milliseconds ? "the most exact is"
                                   : "the cheapest is",
               rung.name);
    fmt::print("  RMSE {:.3g}{}, at the worst of {} places; {} the scene takes{}\n", rung.own.light.rmse,
               residual_text(sweep, wish), advice.places, cost_text(rung, sweep),
               advice.settled ? "" : "; others may be better: more --budget tells");
    std::string scene = path;
    if (!mix.changes.empty()) {
        fmt::print("  {}\n", apply_command(path, options.choices, rung_name(mix.changes), "FOLDER"));
        scene = "FOLDER/" + std::filesystem::path(path).filename().string();
    }
    std::string line = "  snell render " + file_word(scene) + " -o picture.png";
    for (const std::string& choice : choices(bench.scene(), mix.rungs)) line += " --ladder " + choice;
    if (mix.samples > 1) line += fmt::format(" --samples {}", mix.samples);
    fmt::print("{}\n", line);
    return advice.met;
}

// A preset names rungs of ladders, so a scene without ladders has none: what would be in it, and how to get there.
bool explain_presets(const std::string& path, const AccuracyOptions& options, const FoundResult* found) {
    complain(fmt::format("'{}' has no ladders, so no presets were written: a preset names a rung of each ladder", path),
             fmt::format("write a scene with found rung N as a ladder by: {} --as-ladder N -o FOLDER",
                         accuracy_command(path, options.choices)));
    if (!found) return false;
    const std::array<Wish, 3> wishes = quality_wishes();
    for (std::size_t i = 0; i < wishes.size(); ++i)
        if (const auto best = choose(found->timed, wishes[i]))
            fmt::print("{}{:<8}  {}", i == 0 ? "\nof the found rungs these would be\n" : "", quality_names[i],
                       found_choice_text(path, options, *found, *best));
    return false;
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

bool give_advice(const AccuracyOptions& options, const std::string& path, Bench& bench, const Rungs& now,
                 const MeasureOptions& measuring, const Sought* sought, Report& report) {
    const bool limited = options.within || options.error;
    const Wish wish{options.within, options.error};
    bool met = false, saved = true;
    const FoundResult* found = sought ? &sought->found : nullptr;
    MeasureOptions half = measuring;  // the rest is for all kinds together
    if (limited && found) half.seconds /= 2;
    if (!bench.scene().ladders.empty()) {
        met = advise_ladders(options, path, bench, now, half, report, saved);
    } else {
        saved = !options.save_quality || explain_presets(path, options, found);
        if (limited)
            met = options.knobs.empty() ? advise_knobs(path, bench, now, wish, half, report)
                                        : advise_named_knobs(path, wish, report);
    }
    if (limited && found) {
        met = advise_found(path, options, *found, wish, !bench.scene().ladders.empty()) || met;
        if (found->cannot_say.empty()) met = advise_mixed(path, options, bench, *sought, wish, half, report) || met;
    }
    return saved && (met || !limited);
}

}  // namespace snell::app
