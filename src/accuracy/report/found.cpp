#include "src/accuracy/report/report.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/table.h"
#include "src/plan/setup.h"

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
    return rung.at.empty() ? "" : known_text("{:.2g}", rung.worst()->own.light.rmse);
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
    const bool measurable = times && compare_costs(times->ratio, found.costs.control.noise, .01) == Cost::cheaper;
    if (measurable) add(fmt::format("{:.3g} ms of {:.3g}", scene - times->milliseconds, scene));
    if (times && !measurable) add("less time than can be measured");
    if (rung.load_ms.value_or(0) > 0) add(fmt::format("{:.3g} ms of loading", *rung.load_ms));
    if (rung.gpu_bytes > 0) add(fmt::format("{:.3g} MB of GPU memory", 1e-6 * static_cast<double>(rung.gpu_bytes)));
    if (rung.bytes_decoded > 0) add(fmt::format("{:.3g} MB decoded", 1e-6 * static_cast<double>(rung.bytes_decoded)));
    return costs.empty() ? "its time was not measured" : costs;
}

void sort_by_time(const FoundResult& found, Listed& rungs) {
    ranges::stable_sort(rungs, {}, [&](const FoundRung* rung) {
        const RungResult* times = found.times(*rung);
        return times ? times->ratio.middle : std::numeric_limits<double>::infinity();
    });
}

// The cheaper ones that may be worth it: those that were timed, the cheapest on top, then their parts.
Listed listed(const FoundResult& found) {
    Listed rungs;
    for (const FoundRung& rung : found.rungs)
        if (rung.aim == Aim::cheaper && rung.outcome == Outcome::tried && !plainly_visible(rung) &&
            (rung.timed || rung.only_where_tried))
            rungs.push_back(&rung);
    for (const FoundRung& rung : found.rungs)
        if (rung.changes.size() == 1 && !plainly_visible(rung) && ranges::find(rungs, &rung) == rungs.end() &&
            ranges::any_of(rungs, [&](const FoundRung* of) {
                return ranges::find(of->changes, rung.changes[0]) != of->changes.end();
            }))
            rungs.push_back(&rung);
    sort_by_time(found, rungs);
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

// The place and the edit, if that is two lines of the terminal's table; otherwise the place, and what the rung does.
std::string brief_change(const FoundResult& found, const FoundRung& rung) {
    constexpr std::size_t two_lines = 48;
    const std::string place = near_place(place_of(found, rung));
    std::string edit = fmt::format("{}: {}", place, change_of(found, rung));
    const ChangeKind kind = found.changes[rung.changes.front()].kind;
    if (edit.size() <= two_lines && kind != ChangeKind::polynomial) return edit;
    return place + ": " + excerpt(found.words(rung), two_lines - std::min(place.size() + 2, two_lines / 2));
}

struct FoundRow {
    const FoundResult* found;
    const FoundRung* rung;
};

using content::CellKind;
constexpr content::TableColumn<FoundRow> found_columns[]{
    {"rung", CellKind::words,
     [](const FoundRow& r) { return fmt::format("{} ({})", r.found->words(*r.rung), r.rung->name); }},
    {"change", CellKind::code,
     [](const FoundRow& r) { return r.rung->changes.size() > 1 ? std::string() : brief_change(*r.found, *r.rung); }},
    {"time", CellKind::number,
     [](const FoundRow& r) { return r.rung->aim == Aim::unused ? std::string() : shown_ratio(*r.found, *r.rung); }},
    {"FLIP as it opens", CellKind::number, [](const FoundRow& r) { return shown_flip_here(*r.rung); }},
    {"FLIP at worst", CellKind::number, [](const FoundRow& r) { return shown_flip(*r.rung); }},
    {"RMSE at worst", CellKind::number, [](const FoundRow& r) { return shown_error(*r.rung); }},
    {"remarks", CellKind::words,
     [](const FoundRow& r) {
         const bool idle = r.rung->aim == Aim::unused && r.rung->outcome == Outcome::tried;
         return idle ? shown_cost(*r.found, *r.rung) : standing_of(*r.found, *r.rung);
     }},
};

content::Table table_of(const FoundResult& found, const Listed& rungs) {
    std::vector<FoundRow> rows;
    for (const FoundRung* rung : rungs) rows.push_back({&found, rung});
    return std::move(content::table_of(found_columns, rows).without_empty());
}

// The tables of a report, each with its heading. Those that are folded are for someone who looks for them.
struct Part {
    std::string heading;
    Listed rungs;
    bool folded = false;
};

std::vector<Part> parts_of(const FoundResult& found) {
    const auto those = [&](const auto& which) {
        Listed rungs;
        for (const FoundRung& rung : found.rungs)
            if (which(rung)) rungs.push_back(&rung);
        sort_by_time(found, rungs);
        return rungs;
    };
    const auto cheaper = [](const FoundRung& rung) {
        return rung.aim == Aim::cheaper && rung.outcome == Outcome::tried;
    };
    const Listed offered = listed(found);
    const auto rest = [&](const FoundRung& rung) {
        return cheaper(rung) && !plainly_visible(rung) && ranges::find(offered, &rung) == offered.end();
    };
    std::vector<Part> parts{
        {std::string(invisible), found.without_effect()},
        {"Cheaper", offered},
        {std::string(lacking), those([](const FoundRung& rung) {
             return rung.aim == Aim::better && rung.outcome == Outcome::tried && rung.pixels_changed > 0;
         })},
        {fmt::format("plainly visible, with a mean FLIP above {:g}", most_flip),
         those([&](const FoundRung& rung) { return cheaper(rung) && plainly_visible(rung); }), true},
        {"saved no time, or were not timed", those(rest), true},
        {"refused", those([](const FoundRung& rung) { return rung.outcome == Outcome::refused; }), true},
        {"not tried", those([](const FoundRung& rung) { return rung.outcome == Outcome::not_tried; }), true},
    };
    for (Part& part : parts)
        if (part.folded)
            part.heading =
                fmt::format("{} {} {}", part.rungs.size(), part.rungs.size() == 1 ? "rung" : "rungs", part.heading);
    parts.erase(std::remove_if(parts.begin(), parts.end(), [](const Part& part) { return part.rungs.empty(); }),
                parts.end());
    return parts;
}

}  // namespace

bool plainly_visible(const SweepResult& sweep, std::size_t rung) {
    return sweep.sweep.kind == SweepKind::found && rung != sweep.sweep.current && sweep.rungs[rung].flip > most_flip;
}

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
        return counted(rung.worst()->own.nonfinite, "pixel") + " NaN or infinite";
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
        "{} change{} found; {} {} tried alone, and {}, at {} places, of which {} were held out from the search (seed "
        "{}).",
        found.changes.size(), found.changes.size() == 1 ? " was" : "s were", tried, tried == 1 ? "was" : "were",
        counted(combined, "combination"), found.places.size(),
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
    const bool timed = found.timed.timed();
    if (timed) text += fmt::format(" Times are of {}.", size_of_times(found, found.timed_size));
    const bool quick =
        ranges::any_of(found.rungs, [&](const FoundRung& rung) { return rung.quick_ratio > 0 && !found.times(rung); });
    if (quick && found.quick_size[0] < found.width)
        text += fmt::format(
            " 'About' is of a few frames of {} × {}, in which work that does not depend on pixels counts for more.",
            found.quick_size[0], found.quick_size[1]);
    if (found.costs.timed() && (!timed || found.costs_size != found.timed_size))
        text += fmt::format(" What better changes cost, and what changes no pixel, is of {}.",
                            size_of_times(found, found.costs_size));
    if (timed && found.timed.few_rounds) text += " There are too few rounds to compare costs.";
    if (const std::string noise = noise_sentence(found.timed.control); timed && found.timed.trusted() && !noise.empty())
        text += " " + noise;
    return text;
}

SweepResult as_sweep(const FoundResult& found, Aim aim) {
    SweepResult sweep = aim == Aim::cheaper ? found.timed : found.costs;
    sweep.scene = found.scene;
    sweep.sweep.name = fmt::format("found: {}", name(aim));
    sweep.rungs.clear();
    sweep.costs = {};
    for (const FoundRung& rung : found.rungs) {
        if (rung.aim != aim) continue;
        const RungResult* times = found.times(rung);
        RungResult shown = times ? *times : RungResult{};
        shown.name = rung.name;
        take_errors(shown, rung);
        sweep.rungs.push_back(std::move(shown));
    }
    sweep.sweep.reference = sweep.sweep.current = sweep.rungs.size();
    return sweep;
}

std::string found_text(const FoundResult& found) {
    if (found.changes.empty()) return "\nfound rungs: there is nothing in this scene that could be changed\n";
    std::string text = "\nfound rungs\n" + content::paragraph(found_words(found), 2), folded;
    if (!found.cannot_say.empty()) return text;
    const std::vector<Part> parts = parts_of(found);
    if (ranges::none_of(parts, [](const Part& part) { return part.heading == "Cheaper"; }))
        text += content::paragraph(no_cheaper_words(found), 2);
    for (const Part& part : parts)
        if (part.folded)
            folded += (folded.empty() ? "" : "; ") + part.heading;
        else
            text += fmt::format("{}\n{}", part.heading, content::table_text(table_of(found, part.rungs)));
    if (!folded.empty()) text += content::paragraph("Not shown, but in the report: " + folded + ".", 2);
    if (found.timed.timed())
        text += fmt::format("  control: {}, {}\n", ratio_text(found.timed.control.ratio), name(found.timed.clock));
    return text;
}

std::string found_markdown(const FoundResult& found, const std::string& plot) {
    std::string text = fmt::format("\n## {}: found rungs\n\n{}\n", content::escaped(found.scene), found_words(found));
    if (!plot.empty()) text += fmt::format("\n![found rungs: error over time]({})\n", plot);
    for (const Part& part : parts_of(found))
        text += fmt::format("\n{}:\n\n{}", part.heading, content::table_markdown(table_of(found, part.rungs)));
    return text;
}

std::string found_html(const FoundResult& found) {
    std::string text =
        fmt::format("<section><h2>Found rungs</h2><p class=\"words\">{}</p>", content::escaped(found_words(found)));
    if (found.timed.timed()) text += "<div class=\"scroll\">" + plot_html(found.timed) + "</div>";
    for (const Part& part : parts_of(found)) {
        const std::string table = content::table_html(table_of(found, part.rungs));
        const std::string heading = content::escaped(part.heading);
        text += part.folded ? fmt::format("<details><summary>{}</summary>{}</details>", heading, table)
                            : fmt::format("<h3>{}</h3>{}", heading, table);
    }
    text += "<p class=\"facts\">Places:";
    for (std::size_t i = 0; i < found.places.size(); ++i)
        text += fmt::format(" {}{}: {};", i, i < found.searched ? "" : " (held out)",
                            content::escaped(place_text(found.places[i], found.places[0])));
    return text + "</p></section>\n";
}

// Rungs that were found, for other programs.

namespace {

using FoundJson = nlohmann::ordered_json;

FoundJson difference_json(const Difference& difference) {
    FoundJson json{{"own", error_json(difference.own)},
                   {"whole", error_json(difference.whole)},
                   {"pixels_changed", difference.pixels_changed}};
    if (difference.flip) json["flip_mean"] = number(*difference.flip);
    return json;
}

FoundJson found_rung_json(const FoundResult& found, const FoundRung& rung) {
    constexpr std::array<std::string_view, 3> outcomes{"tried", "refused", "not tried"};
    FoundJson json{{"rung", rung.name},
                   {"aim", name(rung.aim)},
                   {"outcome", outcomes[static_cast<std::size_t>(rung.outcome)]},
                   {"standing", standing_of(found, rung)}};
    json["changes"] = FoundJson::array();
    for (const std::size_t i : rung.changes) {
        const Change& change = found.changes[i];
        json["changes"].push_back({{"number", i + 1},
                                   {"kind", facts(change.kind).name},
                                   {"place", found.positions[i]},
                                   {"before", change.before},
                                   {"after", change.after}});
        if (!change.lint.empty()) json["changes"].back()["lint"] = change.lint;
    }
    if (!rung.reason.empty()) json["reason"] = rung.reason;
    if (rung.at.empty()) return json;
    json["size"] = {rung.width, rung.height};
    json["worst_place"] = rung.worst_place();
    json["error"] = difference_json(*rung.worst());
    if (rung.flip()) json["error"]["flip_mean"] = number(*rung.flip());
    json["as_it_opens"] = difference_json(rung.at.front());
    json["searched"] = difference_json(*rung.searched());
    if (const Difference* unseen = rung.unseen()) json["held_out"] = difference_json(*unseen);
    json["only_where_tried"] = rung.only_where_tried;
    json["pixels_changed"] = rung.pixels_changed;
    json["at"] = FoundJson::array();
    for (const Difference& difference : rung.at) json["at"].push_back(difference_json(difference));
    if (rung.quick_ratio > 0) json["quick_ratio"] = rung.quick_ratio;
    if (found.times(rung)) add_times(json, found.sweep_of(rung), *rung.timed, "ratio_to_scene");
    if (rung.aim == Aim::unused) json["saves"] = {{"gpu_bytes", rung.gpu_bytes}, {"bytes_decoded", rung.bytes_decoded}};
    if (rung.load_ms) json["saves"]["load_ms"] = *rung.load_ms;
    return json;
}

}  // namespace

FoundJson found_json(const FoundResult& found) {
    FoundJson json{{"scene", found.scene},
                   {"seed", found.seed},
                   {"words", found_words(found)},
                   {"size", {found.width, found.height}},
                   {"search_size", {found.search_width, found.search_height}},
                   {"quick_size", found.quick_size},
                   {"timed_size", found.timed_size},
                   {"costs_size", found.costs_size},
                   {"clock", name(found.timed.clock)},
                   {"trusted", found.timed.trusted()},
                   {"interrupted", found.interrupted},
                   {"late", found.late}};
    json["aa_control"] = interval_json(found.timed.control.ratio);
    json["places"] = FoundJson::array();
    for (std::size_t i = 0; i < found.places.size(); ++i)
        json["places"].push_back({{"held_out", i >= found.searched},
                                  {"view", view_text(found.places[i].view)},
                                  {"time", found.places[i].time},
                                  {"sets", found.places[i].sets}});
    json["front"] = FoundJson::array();
    for (const FoundRung* rung : found.front()) json["front"].push_back(rung->name);
    json["without_effect"] = FoundJson::array();
    for (const FoundRung* rung : found.without_effect()) json["without_effect"].push_back(rung->name);
    json["rungs"] = FoundJson::array();
    for (const FoundRung& rung : found.rungs) json["rungs"].push_back(found_rung_json(found, rung));
    return json;
}

}  // namespace snell::accuracy
