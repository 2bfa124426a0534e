#include "src/accuracy/report/found.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "src/accuracy/report/plot.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

namespace {

using Listed = std::vector<const FoundRung*>;

template <class One>
std::string of_changes(const FoundResult& found, const FoundRung& rung, std::string_view between, const One& one) {
    std::string text;
    for (const std::size_t change : rung.changes)
        text += fmt::format("{}{}", text.empty() ? "" : between, one(found.changes[change], change));
    return text;
}

std::string shown_error(const FoundRung& rung) {
    return rung.at.empty() ? "?" : known_text("{:.2g}", rung.worst()->own.light.rmse);
}
std::string shown_display(const FoundRung& rung) {
    return rung.at.empty() ? "?" : known_text("{:.2g}", rung.worst()->own.display.rmse);
}
// At the scene's own place: what is seen as the scene opens.
std::string shown_error_here(const FoundRung& rung) {
    return rung.at.empty() ? "?" : known_text("{:.2g}", rung.at.front().own.light.rmse);
}
std::string shown_flip_here(const FoundRung& rung) {
    return rung.at.empty() || !rung.at.front().flip ? "" : fmt::format("{:.4f}", *rung.at.front().flip);
}
std::string shown_flip(const FoundRung& rung) { return rung.flip() ? fmt::format("{:.4f}", *rung.flip()) : ""; }
std::string shown_ratio(const FoundResult& found, const FoundRung& rung) {
    const RungResult* times = found.times(rung);
    if (times) return ratio_text(times->ratio);
    return rung.quick_ratio > 0 ? fmt::format("about {:.2f}", rung.quick_ratio) : "";
}

// What something costs that nobody sees: the difference of the times, memory and loading.
std::string shown_cost(const FoundResult& found, const FoundRung& rung) {
    std::string costs;
    const auto add = [&](const std::string& what) { costs += (costs.empty() ? "costs " : ", ") + what; };
    const RungResult* times = found.times(rung);
    const double scene = times ? found.costs.rungs.back().milliseconds : 0;
    const bool measurable = times && times->ratio.high < 1 && times->milliseconds < .99 * scene;
    if (measurable) add(fmt::format("{:.3g} ms of {:.3g}", scene - times->milliseconds, scene));
    if (times && !measurable) add("less time than can be measured");
    if (rung.load_ms.value_or(0) > 0) add(fmt::format("{:.3g} ms of loading", *rung.load_ms));
    if (rung.gpu_bytes > 0) add(fmt::format("{:.3g} MB of GPU memory", 1e-6 * static_cast<double>(rung.gpu_bytes)));
    if (rung.bytes_decoded > 0) add(fmt::format("{:.3g} MB decoded", 1e-6 * static_cast<double>(rung.bytes_decoded)));
    return costs.empty() ? "its time was not measured" : costs;
}

// Those that were timed first, the cheapest on top, then the others by their numbers. `all`: also those that were
// neither timed nor save anything.
Listed listed(const FoundResult& found, Aim aim, bool all) {
    Listed rungs;
    for (const FoundRung& rung : found.rungs)
        if (rung.aim == aim &&
            (all || rung.timed || (rung.outcome == Outcome::tried && rung.only_where_tried) ||
             (aim == Aim::better && rung.outcome == Outcome::tried)) &&
            (all || aim == Aim::cheaper || rung.pixels_changed > 0))
            rungs.push_back(&rung);
    // "3+7" says nothing to someone who can't see what 3 and 7 are.
    for (const FoundRung& rung : found.rungs)
        if (rung.changes.size() == 1 && ranges::find(rungs, &rung) == rungs.end() &&
            ranges::any_of(rungs, [&](const FoundRung* of) {
                return ranges::find(of->changes, rung.changes[0]) != of->changes.end();
            }))
            rungs.push_back(&rung);
    ranges::stable_sort(rungs, {}, [&](const FoundRung* rung) {
        const RungResult* times = found.times(*rung);
        return times ? times->ratio.middle : std::numeric_limits<double>::infinity();
    });
    return rungs;
}

std::size_t count_of(const FoundResult& found, Outcome outcome) {
    return static_cast<std::size_t>(ranges::count(found.rungs, outcome, &FoundRung::outcome));
}

constexpr std::string_view lacking = "What the picture lacks, and what it would cost";
constexpr std::string_view invisible = "What changes no pixel";
constexpr const char* stopped_early = "stopped before it was tried at other places";

// Why no cheaper rung is listed.
std::string_view no_cheaper_words(const FoundResult& found) {
    if (!found.with_times) return "Times were not wanted, so none is known to be cheaper.";
    bool timed = false, untimed = false, saves = false;
    for (const FoundRung& rung : found.rungs) {
        if (rung.aim != Aim::cheaper || rung.outcome == Outcome::refused) continue;
        (rung.quick_ratio > 0 ? timed : untimed) = true;
        saves = saves || rung.saves;
    }
    if (!timed && !untimed) return "No cheaper change was tried.";
    if (!timed) return "No cheaper change was timed.";
    if (saves) return "The search ended before those that save time were timed in full.";
    return untimed ? "None of those that were timed saves time." : "None of them saves time.";
}

std::string size_of_times(const FoundResult& found, std::array<int, 2> size) {
    return fmt::format("pictures of {} × {}{}", size[0], size[1],
                       size[0] < found.width ? ", because larger ones take too long for the budget" : "");
}

std::string rows_text(const FoundResult& found, const Listed& rungs) {
    std::size_t name = 4, place = 5;
    for (const FoundRung* rung : rungs) {
        name = std::max(name, rung->name.size());
        if (rung->changes.size() == 1) place = std::max(place, place_of(found, *rung).size());
    }
    std::string text =
        fmt::format("  {:<{}}  {:>20}  {:>16}  {:>26}\n", "", name, "", "as it opens", "at the worst place");
    text += fmt::format("  {:<{}}  {:>20}  {:>8}  {:>6}  {:>8}  {:>8}  {:>6}  {:<{}}  {}\n", "rung", name, "time",
                        "RMSE", "FLIP", "RMSE", "display", "FLIP", "place", place, "change");
    for (const FoundRung* rung : rungs) {
        const bool one = rung->changes.size() == 1;
        const std::string standing = standing_of(found, *rung);
        text +=
            fmt::format("  {:<{}}  {:>20}  {:>8}  {:>6}  {:>8}  {:>8}  {:>6}  {:<{}}  {}{}{}\n", rung->name, name,
                        shown_ratio(found, *rung), shown_error_here(*rung), shown_flip_here(*rung), shown_error(*rung),
                        shown_display(*rung), shown_flip(*rung), one ? utf8::printable(place_of(found, *rung)) : "",
                        place, kind_of(found, *rung), one ? ": " + utf8::printable(change_of(found, *rung)) : "",
                        standing.empty() ? "" : " (" + standing + ")");
    }
    return text;
}

std::string cells_html(const FoundResult& found, const FoundRung& rung) {
    const std::string place = rung.changes.size() == 1 ? place_of(found, rung) : "";
    return fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td "
        "style=\"text-align:left\">{}</td><td "
        "style=\"text-align:left\">{}</td><td>{}</td></tr>",
        rung.name, shown_ratio(found, rung), shown_error_here(rung), shown_flip_here(rung), shown_error(rung),
        shown_display(rung), shown_flip(rung), rung.pixels_changed, escaped(place),
        escaped(kind_of(found, rung) + (place.empty() ? "" : ": " + change_of(found, rung))),
        escaped(standing_of(found, rung)));
}

std::string table_html(const FoundResult& found, const Listed& rungs) {
    std::string text =
        "<div class=\"scroll\"><table><tr><th></th><th></th><th colspan=\"2\">as the scene opens</th><th colspan=\"3\">"
        "at the worst view and values</th><th></th><th></th><th></th><th></th></tr><tr><th>rung</th><th>time</th>"
        "<th>RMSE</th><th>FLIP</th><th>RMSE</th><th>RMSE of "
        "display</th><th>FLIP</th><th>pixels</th><th>place</th><th>change</th><th></th></tr>";
    for (const FoundRung* rung : rungs) text += cells_html(found, *rung);
    return text + "</table></div>";
}

// A bar would begin the next cell, even in code.
std::string cell_markdown(std::string_view text) {
    std::string cell = escaped(text);
    for (std::size_t at = 0; (at = cell.find('|', at)) != cell.npos;) cell.replace(at, 1, "&#124;");
    return cell;
}

std::string table_markdown(const FoundResult& found, const Listed& rungs) {
    std::string text =
        "\n| rung | time | RMSE, as it opens | FLIP | RMSE, at worst | of display | FLIP | place | change | "
        "|\n|---|--:|--:|--:|--:|--:|--:|---|---|---|\n";
    for (const FoundRung* rung : rungs) {
        const bool one = rung->changes.size() == 1;
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {}{} | {} |\n", rung->name,
                            shown_ratio(found, *rung), shown_error_here(*rung), shown_flip_here(*rung),
                            shown_error(*rung), shown_display(*rung), shown_flip(*rung),
                            one ? cell_markdown(place_of(found, *rung)) : "", kind_of(found, *rung),
                            one ? ": <code>" + cell_markdown(change_of(found, *rung)) + "</code>" : "",
                            cell_markdown(standing_of(found, *rung)));
    }
    return text;
}

}  // namespace

std::string place_of(const FoundResult& found, const FoundRung& rung) {
    return of_changes(found, rung, " ", [&](const Change&, std::size_t i) { return found.positions[i]; });
}

std::string change_of(const FoundResult& found, const FoundRung& rung) {
    const auto shown = [](const std::string& text) { return text.empty() ? "(nothing)" : text; };
    return of_changes(found, rung, "; ", [&](const Change& change, std::size_t i) {
        std::string text = shown(change.before) + " → " + shown(change.after);
        if (i < found.others.size())
            for (const std::string& other : found.others[i]) text += ", " + other;
        return text;
    });
}

std::string kind_of(const FoundResult& found, const FoundRung& rung) {
    return rung.changes.size() == 1 ? std::string(facts(found.changes[rung.changes[0]].kind).name) : "combination";
}

std::string standing_of(const FoundResult& found, const FoundRung& rung) {
    if (rung.outcome == Outcome::refused) return "refused: " + rung.reason;
    if (rung.outcome == Outcome::not_tried) return "not tried: " + rung.reason;
    if (rung.at.empty()) return "";
    if (!std::isfinite(rung.worst()->own.light.rmse))
        return pixels_text(rung.worst()->own.nonfinite) + " NaN or infinite";
    const std::string elsewhere =
        rung.only_where_tried ? "at other views and values its error is more than twice as large" : "";
    if (rung.aim == Aim::unused)
        return rung.pixels_changed > 0 ? "changes pixels" : rung.held_out ? "changes 0 pixels" : stopped_early;
    if (const RungResult* times = found.times(rung)) {
        const std::string standing = rung.aim == Aim::cheaper ? standing_text(found.timed, *times) : "";
        return standing + (standing.empty() || elsewhere.empty() ? "" : "; ") + elsewhere;
    }
    if (!elsewhere.empty()) return elsewhere;
    if (rung.timed) return "not timed";
    if (rung.aim == Aim::better && rung.held_out) return "";
    if (rung.aim == Aim::better) return found.interrupted ? stopped_early : "not held out: the time was up";
    if (!found.with_times || !(rung.quick_ratio > 0))
        return rung.held_out || rung.reason.empty() ? "not timed" : "not held out: " + rung.reason;
    if (!rung.saves) return rung.changes.size() > 1 ? "saves no more than a part of it" : "saves no time";
    return rung.held_out ? "not timed" : "another one saves more";
}

std::string found_words(const FoundResult& found) {
    if (!found.cannot_say.empty()) return "Nothing can be said: " + found.cannot_say + ".";
    const auto tried = static_cast<std::size_t>(ranges::count_if(
        found.rungs, [](const FoundRung& rung) { return rung.outcome == Outcome::tried && rung.changes.size() == 1; }));
    const auto unknown = static_cast<std::size_t>(ranges::count_if(found.rungs, [&](const FoundRung& rung) {
        return rung.outcome == Outcome::refused &&
               ranges::any_of(rung.changes, [&](std::size_t change) { return !found.changes[change].probes.empty(); });
    }));
    const std::size_t combined = count_of(found, Outcome::tried) - tried,
                      refused = count_of(found, Outcome::refused) - unknown,
                      untried = count_of(found, Outcome::not_tried);
    std::string text = fmt::format(
        "{} change{} found; {} {} tried alone, and {} combination{}, at {} places, of which {} were held out from the "
        "search (seed {}).",
        found.changes.size(), found.changes.size() == 1 ? " was" : "s were", tried, tried == 1 ? "was" : "were",
        combined, combined == 1 ? "" : "s", found.places.size(),
        found.places.size() - std::min(found.searched, found.places.size()), found.seed);
    if (refused > 0)
        text += fmt::format(" {} would not compile, make another error or warning, or leave out what --set gives.",
                            refused);
    if (unknown > 0) text += fmt::format(" {} would need a mean that is not known.", unknown);
    if (untried > 0)
        text += fmt::format(" {} not tried: {}.", untried,
                            found.interrupted ? "the search was stopped" : "the time was up");
    text += fmt::format(
        " Errors are differences from the scene as it is, in pictures of {} × {}, as the scene opens and where they "
        "are largest.",
        found.search_width, found.search_height);
    if (found.broken) text += fmt::format(" But {}; these pixels are not compared.", found.broken_words());
    const auto has_times = [](const SweepResult& sweep) {
        return !sweep.rungs.empty() && sweep.rungs.back().rounds > 0;
    };
    const bool timed = has_times(found.timed);
    if (timed) text += fmt::format(" Times are of {}.", size_of_times(found, found.timed_size));
    if (has_times(found.costs) && (!timed || found.costs_size != found.timed_size))
        text += fmt::format(" What better changes cost, and what changes no pixel, is of {}.",
                            size_of_times(found, found.costs_size));
    if (timed && found.timed.few_rounds) text += " There are too few rounds to compare costs.";
    if (timed && !found.timed.few_rounds && found.timed.control.noisy)
        text += fmt::format(
            " The measurement is too noisy to compare costs: the scene, timed twice, took {} times as long the second "
            "time.",
            ratio_text(found.timed.control.ratio));
    if (timed && found.timed.trusted()) text += noise_sentence(found.timed.control);
    return text;
}

SweepResult as_sweep(const FoundResult& found, Aim aim) {
    SweepResult sweep = aim == Aim::cheaper ? found.timed : found.costs;
    sweep.scene = found.scene;
    sweep.sweep.name = fmt::format("found: {}", aim == Aim::cheaper  ? "cheaper"
                                                : aim == Aim::better ? "better"
                                                                     : "unused");
    sweep.rungs.clear();
    for (const FoundRung& rung : found.rungs) {
        if (rung.aim != aim) continue;
        const RungResult* times = found.times(rung);
        RungResult shown = times ? *times : RungResult{.name = rung.name};
        shown.drawn = !rung.at.empty();
        if (shown.drawn) {
            shown.own = rung.worst()->own;
            shown.whole = rung.worst()->whole;
            shown.alone = shown.own.light;
            shown.flip = rung.flip().value_or(std::nan(""));
        }
        sweep.rungs.push_back(std::move(shown));
    }
    sweep.sweep.reference = sweep.sweep.current = sweep.rungs.size();
    return sweep;
}

std::string found_text(const FoundResult& found) {
    if (found.changes.empty()) return "\nfound rungs: there is nothing in this scene that could be changed\n";
    std::string text = fmt::format("\nfound rungs\n  {}\n", found_words(found));
    if (!found.cannot_say.empty()) return text;
    if (const Listed none = found.without_effect(); !none.empty()) {
        text += fmt::format("{}\n", invisible);
        for (const FoundRung* rung : none)
            text += fmt::format("  {:<4}  {}: {}: changes 0 pixels, {}\n", rung->name,
                                utf8::printable(place_of(found, *rung)), utf8::printable(change_of(found, *rung)),
                                shown_cost(found, *rung));
    }
    if (const Listed rungs = listed(found, Aim::cheaper, false); !rungs.empty())
        text += "Cheaper\n" + rows_text(found, rungs);
    else
        text += fmt::format("  {}\n", no_cheaper_words(found));
    if (const Listed rungs = listed(found, Aim::better, false); !rungs.empty())
        text += fmt::format("{}\n", lacking) + rows_text(found, rungs);
    if (!found.timed.rungs.empty() && found.timed.rungs.back().rounds > 0)
        text += fmt::format("  control: {}, {}\n", ratio_text(found.timed.control.ratio), name(found.timed.clock));
    return text;
}

std::string found_markdown(const FoundResult& found, const std::string& plot) {
    std::string text = fmt::format("\n## {}: found rungs\n\n{}\n", escaped(found.scene), found_words(found));
    if (const Listed none = found.without_effect(); !none.empty()) {
        text += fmt::format("\n{}:\n\n", invisible);
        for (const FoundRung* rung : none)
            text += fmt::format("- {}: {}: <code>{}</code> changes 0 pixels, {}\n", rung->name,
                                escaped(place_of(found, *rung)), escaped(change_of(found, *rung)),
                                shown_cost(found, *rung));
    }
    if (!plot.empty()) text += fmt::format("\n![found rungs: error over time]({})\n", plot);
    text += table_markdown(found, listed(found, Aim::cheaper, true));
    if (const Listed better = listed(found, Aim::better, true); !better.empty())
        text += fmt::format("\n{}:\n", lacking) + table_markdown(found, better);
    return text;
}

std::string found_html(const FoundResult& found) {
    std::string text =
        fmt::format("<section><h2>Found rungs</h2><p class=\"words\">{}</p>", escaped(found_words(found)));
    if (const Listed none = found.without_effect(); !none.empty()) {
        text += fmt::format("<h3>{}</h3><ul>", invisible);
        for (const FoundRung* rung : none)
            text += fmt::format("<li>{}: {}: <code>{}</code> changes 0 pixels, {}</li>", rung->name,
                                escaped(place_of(found, *rung)), escaped(change_of(found, *rung)),
                                shown_cost(found, *rung));
        text += "</ul>";
    }
    if (found.timed.rungs.size() > 1 && found.timed.rungs.back().rounds > 0)
        text += "<div class=\"scroll\">" + plot_svg(found.timed) + "</div>";
    text += table_html(found, listed(found, Aim::cheaper, true));
    if (const Listed better = listed(found, Aim::better, true); !better.empty())
        text += fmt::format("<h3>{}</h3>", lacking) + table_html(found, better);
    text += "<p class=\"facts\">Places:";
    for (std::size_t i = 0; i < found.places.size(); ++i)
        text += fmt::format(" {}{}: {};", i, i < found.searched ? "" : " (held out)",
                            escaped(place_text(found.places[i], found.places[0])));
    return text + "</p></section>\n";
}

}  // namespace snell::accuracy
