// Tables for a terminal and sentences that summarise the numbers; a sentence without support in the numbers is left
// out.
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

namespace {

const RungResult& base_of(const SweepResult& sweep) { return sweep.rungs[sweep.sweep.current]; }
// Null if the reference is none of the rungs.
const RungResult* last_of(const SweepResult& sweep) {
    return sweep.sweep.reference < sweep.rungs.size() ? &sweep.rungs[sweep.sweep.reference] : nullptr;
}

std::string error_text(const SweepResult& sweep, const RungResult& rung) {
    if (sweep.metric == Metric::degrees) return fmt::format("{:.3g}°", sweep.error(rung));
    return fmt::format("RMSE {:.2g}", rung.own.light.rmse);
}

std::string list_text(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
    return text;
}

std::string price_sentence(const SweepResult& sweep) {
    if (!last_of(sweep)) return {};
    const RungResult &base = base_of(sweep), &reference = *last_of(sweep);
    if (&base == &reference) return "The scene already uses the reference.";
    if (reference.rounds == 0) return {};
    const Cost cost = sweep.costs.of(sweep.sweep.reference, sweep.sweep.current);
    if (cost == Cost::equal || cost == Cost::not_told)
        return fmt::format("The cost of '{}' {}: {} times that of '{}'.", reference.name,
                           cost == Cost::equal ? "is the same" : "can't be told from the scene's own",
                           ratio_text(reference.ratio), base.name);
    return fmt::format("'{}' takes {} times as long as '{}', which has an error of {}.", reference.name,
                       ratio_text(reference.ratio), base.name, error_text(sweep, base));
}

// The cheapest rung on the front that halves the error of the scene's own rung.
std::string bargain_sentence(const SweepResult& sweep) {
    const RungResult& base = base_of(sweep);
    if (!(sweep.error(base) > 0) || !std::isfinite(sweep.error(base))) return {};
    const RungResult* best = nullptr;
    for (const RungResult& rung : sweep.rungs) {
        if (!sweep.on_front(rung) || &rung == last_of(sweep)) continue;
        if (sweep.error(rung) > .5 * sweep.error(base)) continue;
        if (!best || rung.milliseconds < best->milliseconds) best = &rung;
    }
    if (!best) return {};
    return fmt::format("The best value is '{}': an error of {} instead of {}, for {} times the time.", best->name,
                       error_text(sweep, *best), error_text(sweep, base), ratio_text(best->ratio));
}

std::string standing_sentences(const SweepResult& sweep) {
    std::string text;
    for (const Standing standing : {Standing::dominated, Standing::saves_none, Standing::unsure})
        for (std::size_t other = 0; other < sweep.rungs.size(); ++other) {
            std::vector<std::string> names;
            for (const RungResult& rung : sweep.rungs)
                if (rung.verdict == Verdict{standing, other}) names.push_back("'" + rung.name + "'");
            if (names.empty()) continue;
            const std::string& by = sweep.rungs[other].name;
            text += standing == Standing::dominated
                        ? fmt::format(" '{}' is cheaper than {}, and not worse.", by, list_text(names))
                        : fmt::format(" {} {} '{}', which is more exact.", list_text(names),
                                      standing == Standing::unsure ? names.size() > 1 ? "are not surely cheaper than"
                                                                                      : "is not surely cheaper than"
                                      : names.size() > 1           ? "cost as much as"
                                                                   : "costs as much as",
                                      by);
        }
    return text;
}

}  // namespace

std::string ratio_text(const Interval& ratio) {
    if (!std::isfinite(ratio.middle)) return "?";
    if (!ratio.known()) return fmt::format("{:.3g}", ratio.middle);
    const double width = std::max(ratio.width(), 1e-4);
    const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(width))) + 1, 0, 3);
    return fmt::format("{:.{}f} [{:.{}f}, {:.{}f}]", ratio.middle, digits, ratio.low, digits, ratio.high, digits);
}

std::string wish_text(const Wish& wish, std::string_view errors_from) {
    std::string text;
    if (wish.error) text = fmt::format("RMSE of light from {} at most {:.3g}", errors_from, *wish.error);
    if (wish.milliseconds) text += fmt::format("{}at most {:.3g} ms", text.empty() ? "" : " and ", *wish.milliseconds);
    return text.empty() ? "whatever its error is" : text;
}

std::string residual_text(const SweepResult& sweep, const Wish& wish) {
    if (!wish.error || sweep.residual == 0) return "";
    return sweep.residual ? fmt::format(" and up to {:.2g} of the reference", *sweep.residual)
                          : " and an unknown part of the reference";
}

std::string time_text(const RungResult& rung) {
    if (!std::isfinite(rung.high))
        return fmt::format("{:.3g} ms (from {}, too few for an interval)", rung.milliseconds,
                           counted(static_cast<std::size_t>(rung.rounds), "round"));
    return fmt::format("{:.3g} ms [{:.3g}, {:.3g}]", rung.milliseconds, rung.low, rung.high);
}

std::string cost_text(const RungResult& rung, const SweepResult& sweep) {
    return fmt::format("{} of {}, {} times what", time_text(rung), name(sweep.clock), ratio_text(rung.ratio));
}

std::string standing_text(const SweepResult& sweep, const RungResult& rung) {
    if (!sweep.trusted()) return "";
    const std::string by = rung.verdict.by == nobody ? "" : sweep.rungs[rung.verdict.by].name;
    switch (rung.verdict.standing) {
        case Standing::front:
            return "front";
        case Standing::dominated:
            return "dominated by " + by;
        case Standing::saves_none:
            return "no saving: " + by;
        case Standing::unsure:
            return "not surely cheaper than " + by;
        case Standing::unknown:
            return std::isinf(sweep.error(rung)) ? "no value" : "not measured";
    }
    return "";
}

bool unmeasured(const SweepResult& sweep) { return ranges::none_of(sweep.rungs, &RungResult::drawn); }

std::string area_text(const SweepResult& sweep) {
    return sweep.own_pixels > 0 ? fmt::format("over the {} that its draws cover", counted(sweep.own_pixels, "pixel"))
                                : "over the whole picture";
}

std::string known_text(std::string_view format, double value) {
    return std::isnan(value) ? "?" : fmt::vformat(format, fmt::make_format_args(value));
}

std::string psnr_text(double psnr) {
    if (std::isfinite(psnr)) return fmt::format("{:.1f}", decibels(psnr, 1));
    return std::isnan(psnr) ? "?" : psnr > 0 ? "equal" : "not finite";
}

std::string notes_text(const SweepResult& sweep, const RungResult& rung) {
    std::vector<std::string> notes;
    if (&rung == last_of(sweep)) notes.emplace_back("reference");
    if (std::string standing = standing_text(sweep, rung); !standing.empty()) notes.push_back(std::move(standing));
    if (rung.below_residual && sweep.metric == Metric::rmse) notes.emplace_back("not told apart from the reference");
    if (rung.saturated) notes.emplace_back("decorrelated");
    if (rung.cliff) notes.emplace_back("cliff");
    if (rung.own.nonfinite > 0) notes.push_back(counted(rung.own.nonfinite, "pixel") + " NaN or infinite");
    if (rung.hidden())
        notes.push_back(fmt::format("alone RMSE {:.2g} here, {:.2g} {}", rung.alone.rmse, rung.elsewhere->rmse,
                                    sweep.sweep.elsewhere));
    return fmt::format("{}", fmt::join(notes, ", "));
}

std::string noise_sentence(const Control& control) {
    if (!(control.noise > same_cost)) return "";
    if (std::isinf(control.noise)) return "There are too few rounds to compare costs.";
    return fmt::format(
        "Differences of costs below {:.0f} % say nothing: the same picture, timed twice, differed so much.",
        100 * control.noise);
}

namespace {

std::string cost_sentences(const SweepResult& sweep) {
    std::string text;
    if (!sweep.timed()) return "Nothing was timed.";
    if (sweep.few_rounds) return "There are too few rounds to compare costs.";
    text = price_sentence(sweep);
    if (const std::string noise = noise_sentence(sweep.control); !noise.empty()) text += " " + noise;
    if (const std::string bargain = bargain_sentence(sweep); !bargain.empty()) text += " " + bargain;
    // For a lattice, the table has this information.
    if (sweep.sweep.kind != SweepKind::lattice) text += standing_sentences(sweep);
    return text;
}

// What is said of the rungs for which `which` is true, such as " {} is dear." of one, and of several; empty if there
// are none.
template <class Which>
std::string said_of(const SweepResult& sweep, const Which& which, std::string_view one, std::string_view several) {
    std::vector<std::string> names;
    for (const RungResult& rung : sweep.rungs)
        if (rung.drawn && which(rung)) names.push_back("'" + rung.name + "'");
    if (names.empty()) return {};
    const std::string list = list_text(names);
    return fmt::vformat(names.size() > 1 ? several : one, fmt::make_format_args(list));
}

// "'a' and 'b'", or how many there are of more than three.
std::string some_text(const std::vector<std::string>& names) {
    return names.size() > 3 ? fmt::format("{} rungs", names.size()) : list_text(names);
}

// What there was no time for.
std::string left_out_sentence(const SweepResult& sweep) {
    std::vector<std::string> undrawn, untimed;
    for (const RungResult& rung : sweep.rungs)
        if (!rung.drawn)
            undrawn.push_back("'" + rung.name + "'");
        else if (sweep.timed() && rung.rounds == 0)
            untimed.push_back("'" + rung.name + "'");
    std::string text;
    if (!undrawn.empty())
        text += fmt::format(" Left out: {}{}.", some_text(undrawn), sweep.late ? "; more --budget draws all" : "");
    if (!untimed.empty()) text += fmt::format(" There was no time to time {}.", some_text(untimed));
    return text;
}

std::string hidden_sentences(const SweepResult& sweep) {
    constexpr std::string_view last = "with the other ladders at their last rungs", scene = "where the scene stands";
    std::string text;
    for (const RungResult& rung : sweep.rungs) {
        if (!rung.hidden()) continue;
        const double here = rung.alone.rmse, there = rung.elsewhere->rmse;
        const std::string_view other = sweep.sweep.elsewhere, own = other == scene ? last : scene;
        text += fmt::format(
            " '{}' is hidden by another ladder's rung {}, where it changes RMSE {:.2g}; {} it is {:.2g}.", rung.name,
            here < there ? own : other, std::min(here, there), here < there ? other : own, std::max(here, there));
    }
    return text;
}

struct RungRow {
    const SweepResult* sweep;
    const RungResult* rung;

    bool timed() const { return rung->drawn && rung->rounds > 0; }
};

using content::CellKind;
constexpr content::TableColumn<RungRow> rung_columns[]{
    {"rung", CellKind::words, [](const RungRow& r) { return r.rung->name; }},
    {"ms", CellKind::number,
     [](const RungRow& r) { return r.timed() ? fmt::format("{:.3g}", r.rung->milliseconds) : ""; }},
    {"relative to current", CellKind::number,
     [](const RungRow& r) { return r.timed() ? ratio_text(r.rung->ratio) : ""; }},
    {"RMSE", CellKind::number, [](const RungRow& r) { return known_text("{:.2g}", r.rung->own.light.rmse); }},
    {"PSNR, dB", CellKind::number, [](const RungRow& r) { return psnr_text(r.rung->own.light.psnr); }},
    {"PSNR of display", CellKind::number, [](const RungRow& r) { return psnr_text(r.rung->own.display.psnr); }},
    {"PSNR of all", CellKind::number, [](const RungRow& r) { return psnr_text(r.rung->whole.light.psnr); }},
    {"RMSE alone", CellKind::number, [](const RungRow& r) { return known_text("{:.2g}", r.rung->alone.rmse); }},
    {"FLIP", CellKind::number, [](const RungRow& r) { return known_text("{:.3f}", r.rung->flip); }},
    {"degrees", CellKind::number,
     [](const RungRow& r) { return r.rung->degrees ? known_text("{:.3g}", r.rung->degrees->mean) : ""; }},
    {"remarks", CellKind::words, [](const RungRow& r) { return notes_text(*r.sweep, *r.rung); }},
};

}  // namespace

std::vector<const SweepResult*> plots_of(const Report& report) {
    std::vector<const SweepResult*> plots;
    for (const SweepResult& sweep : report.sweeps) plots.push_back(&sweep);
    for (const FoundResult& found : report.found)
        if (found.timed.rungs.size() > 1) plots.push_back(&found.timed);
    return plots;
}

std::string in_words(const SweepResult& sweep) {
    if (!sweep.cannot_say.empty())
        return fmt::format("Can't say: {}.{}", sweep.cannot_say, unmeasured(sweep) ? "" : left_out_sentence(sweep));
    std::string text = cost_sentences(sweep);
    const auto reference = last_of(sweep);
    if (sweep.metric == Metric::rmse)
        text += said_of(
            sweep, [&](const RungResult& rung) { return rung.below_residual && &rung != reference; },
            " {} is not told apart from the reference.", " {} are not told apart from the reference.");
    if (sweep.sweep.kind != SweepKind::lattice)
        text += said_of(sweep, std::mem_fn(&RungResult::saturated),
                        " The error of {} is so large that RMSE no longer ranks.",
                        " The errors of {} are so large that RMSE no longer ranks.");
    text += said_of(sweep, std::mem_fn(&RungResult::cliff), " {} is more expensive than both neighbours (a cliff).",
                    " {} are more expensive than both neighbours (a cliff).");
    constexpr std::string_view odd = " Some pixels of {} are NaN or infinite.";
    text += said_of(
        sweep, [](const RungResult& rung) { return rung.whole.nonfinite > 0; }, odd, odd);
    text += left_out_sentence(sweep);
    text += hidden_sentences(sweep);
    return text.starts_with(' ') ? text.substr(1) : text;
}

std::string header_text(const Report& report) {
    const Circumstances& w = report.where;
    return content::paragraph(
               fmt::format("{}: {}x{}, up to {} rounds, {}", w.scene, w.width, w.height, w.rounds, w.date), 0) +
           content::paragraph(fmt::format("{} ({}), {}, {} cores, load {:.1f} before, {:.1f} after", w.renderer, w.gl,
                                          w.cpu, w.cores, w.load_before, w.load_after),
                              0) +
           content::paragraph(fmt::format("{} Other ladders are as in the {}.", errors_are, w.others()), 0);
}

content::Table rung_table(const SweepResult& sweep) {
    std::vector<RungRow> rows;
    for (const RungResult& rung : sweep.rungs)
        if (rung.drawn) rows.push_back({&sweep, &rung});
    content::Table table = content::table_of(rung_columns, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) table.rows[i].marked = rows[i].rung == &base_of(sweep);
    return std::move(table.without_empty());
}

std::string table_text(const SweepResult& sweep) {
    if (unmeasured(sweep))
        return fmt::format("\n{}: not measured\n{}", sweep.sweep.name, content::paragraph(in_words(sweep), 2));
    std::string text =
        "\n" +
        content::paragraph(fmt::format("{}, {}; {}", sweep.sweep.name, area_text(sweep), sweep.reference_note), 0);
    text += content::table_text(rung_table(sweep));
    if (sweep.timed()) text += fmt::format("  control: {}, {}\n", ratio_text(sweep.control.ratio), name(sweep.clock));
    return text + content::paragraph(in_words(sweep), 2);
}

// The report as a page of Markdown.

namespace {

std::string part(const SweepResult& sweep, const std::string& plot) {
    if (unmeasured(sweep))
        return fmt::format("\n{}: {}: not measured\n", content::escaped(sweep.scene), sweep.sweep.name);
    const bool timed = sweep.timed();
    std::string text =
        fmt::format("\n## {}: {}\n\n{}\n", content::escaped(sweep.scene), sweep.sweep.name, in_words(sweep));
    text += fmt::format("\nErrors {}; {}.{}\n", area_text(sweep), sweep.reference_note,
                        timed ? fmt::format(" Control: {}.", ratio_text(sweep.control.ratio)) : std::string());
    if (timed && !plot.empty()) text += fmt::format("\n![{}: error over time]({})\n", sweep.sweep.name, plot);
    return text + "\n" + content::table_markdown(rung_table(sweep));
}

}  // namespace

std::string markdown_text(const Report& report, const std::vector<std::string>& plots) {
    const Circumstances& w = report.where;
    std::string text = fmt::format(
        "# Accuracy and cost, measured\n\n{}, {} cores, {}; {} ({}); {}; {}; {} × {} pixels, up to {} rounds, other "
        "ladders as in the {}; load {:.1f} before, {:.1f} after.\n\nThe scene's rung is bold. {} The reference has all "
        "last rungs, and the finest samples, meshes and filter that the time allowed. Errors are the same on any "
        "machine, apart from rounding and the reference. Times are valid for this machine at that time.\n",
        w.cpu, w.cores, w.os, w.renderer, w.gl, w.tool, w.date, w.width, w.height, w.rounds, w.others(), w.load_before,
        w.load_after, errors_are);
    const std::vector<const SweepResult*> plotted = plots_of(report);
    const auto plot_for = [&](const SweepResult& sweep) {
        const auto at = static_cast<std::size_t>(ranges::find(plotted, &sweep) - plotted.begin());
        return at < plots.size() ? plots[at] : std::string();
    };
    for (const SweepResult& sweep : report.sweeps) text += part(sweep, plot_for(sweep));
    for (const FoundResult& found : report.found) text += found_markdown(found, plot_for(found.timed));
    return text;
}

}  // namespace snell::accuracy
