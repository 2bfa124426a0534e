// Reports of measurements as text, CSV, JSON, Markdown and HTML. Values in, text out; no files, no GL.
#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <nlohmann/json_fwd.hpp>

#include "src/accuracy/advice.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/metrics.h"
#include "src/content/table.h"

namespace snell::accuracy {

// Where, when and how the measurement was done.
struct Circumstances {
    std::string scene = {};  // as the user gave it
    std::string tool = {}, date = {}, cpu = {}, os = {};
    int cores = 0;
    double load_before = 0, load_after = 0;  // load average over one minute: processes that run or wait
    std::string renderer = {}, vendor = {}, gl = {};
    int width = 0, height = 0, rounds = 0;
    double time = 0;
    double query_over_wall = 0;  // ratio of the GPU's timer to wall time; 0 if it was not measured
    std::string from = {};       // "reference", "scene" or "lattice"
    std::vector<std::string> sets = {};

    // What those ladders are at that a sweep does not vary: "reference" or "scene".
    std::string_view others() const { return from == "lattice" ? std::string_view("reference") : from; }
};

struct Report {
    Circumstances where;
    std::vector<SweepResult> sweeps;
    std::vector<FoundResult> found;     // of each scene whose rungs were sought
    std::vector<std::string> problems;  // of the scene, one line each
};

// What is plotted: ladders and knobs, then the found rungs that were timed.
std::vector<const SweepResult*> plots_of(const Report& report);
// A few sentences about a sweep, derived from its numbers alone.
std::string in_words(const SweepResult& sweep);
// Formats as "1.02 [.99, 1.05]", with as many digits as the interval justifies.
std::string ratio_text(const Interval& ratio);
// Such as "1.02 ms [0.99, 1.05]", or why there is no interval; and with its ratio to the current rung's.
std::string time_text(const RungResult& rung);
std::string cost_text(const RungResult& rung, const SweepResult& sweep);
// Such as "RMSE of light from the reference at most 0.1 and at most 16 ms".
std::string wish_text(const Wish& wish, std::string_view errors_from = "the reference");
// What is added to an error when it is compared with a limit, such as " and up to 0.01 of the reference".
std::string residual_text(const SweepResult& sweep, const Wish& wish);
// Which differences are not told because of the noise of the run, as a sentence; empty if it is small.
std::string noise_sentence(const Control& control);
// The rung's position relative to the front: "front", "dominated by x", "no saving: x" or "not surely cheaper than x";
// empty if the times are not trusted.
std::string standing_text(const SweepResult& sweep, const RungResult& rung);

// All remarks on the rung: its standing, and what a reader must know before trusting its error.
std::string notes_text(const SweepResult& sweep, const RungResult& rung);
// Nothing of the sweep was drawn: there was no time for it.
bool unmeasured(const SweepResult& sweep);
// Which pixels its errors are of.
std::string area_text(const SweepResult& sweep);
// A number in a format such as "{:.2g}"; "?" if it is unknown (NaN).
std::string known_text(std::string_view format, double value);
// Decibels, or what there is instead: "equal", "not finite", "?".
std::string psnr_text(double psnr);
// What errors are of, in a sentence.
inline constexpr std::string_view errors_are =
    "Errors are of light: display values decoded by the curve of sRGB, before quantisation. Those of the display "
    "values themselves are given next to them. 'Alone' compares with the last rung at the scene's own knobs.";

// Its rungs; the scene's own is marked.
content::Table rung_table(const SweepResult& sweep);
// Text for a terminal, of at most content::page_columns.
std::string table_text(const SweepResult& sweep);
std::string header_text(const Report& report);

// A row of column names, then one row for each rung.
std::string csv_text(const Report& report);
inline constexpr int report_schema = 3;  // of this JSON
std::string json_text(const Report& report);
// A single file that needs no network; its plots are inline SVG. It begins with `slide`, an element of HTML.
std::string html_text(const Report& report, std::string_view slide = {});
// A page of Markdown; `plots` has the paths of the plots of plots_of().
std::string markdown_text(const Report& report, const std::vector<std::string>& plots);
// The plot of error over time, an <svg> element in the colours of that page.
std::string plot_html(const SweepResult& sweep);
// The same for use in a paper: black on a transparent background.
std::string svg_text(const SweepResult& sweep);

// Numbers and errors as JSON.

// JSON has no infinity; null stands for it.
inline nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json interval_json(const Interval& interval) {
    const double low = interval.known() ? interval.low : std::nan("");
    return {{"median", number(interval.middle)}, {"lo95", number(low)}, {"hi95", number(interval.high)}};
}

// Of a rung that was timed; `base`: what its ratio is to.
inline void add_times(nlohmann::ordered_json& json, const SweepResult& sweep, std::size_t index, const char* base) {
    const RungResult& rung = sweep.rungs[index];
    json["n_rounds"] = rung.rounds;
    json["ms"] = interval_json({rung.low, rung.milliseconds, rung.high});
    json[base] = interval_json(rung.ratio);
    json["cost"] = name(sweep.costs.of(index, sweep.sweep.current));
}

inline nlohmann::ordered_json figures_json(const Figures& figures) {
    return {{"rmse", number(figures.rmse)},
            {"psnr_db", number(figures.psnr)},
            {"max_abs", number(figures.max)},
            {"mean_abs", number(figures.mean)}};
}

// An RMSE of null with pixels that are not finite is infinite, unless something else tells why nothing is known.
inline nlohmann::ordered_json error_json(const Error& error) {
    return {{"light", figures_json(error.light)},
            {"display", figures_json(error.display)},
            {"correlation", number(error.correlation)},
            {"pixels", error.pixels},
            {"nonfinite", error.nonfinite}};
}

// What reports say of rungs that were found.

// Of a combination: of each of its changes, separated by blanks.
std::string place_of(const FoundResult& found, const FoundRung& rung);
// Such as "i < 8 → i < 4".
std::string change_of(const FoundResult& found, const FoundRung& rung);
// Such as "fewer-rounds", or "combination".
std::string kind_of(const FoundResult& found, const FoundRung& rung);
// Its relation to the front, or why it has none, such as "only in the frame that was tried".
std::string standing_of(const FoundResult& found, const FoundRung& rung);
// What was tried, where and how, in sentences.
std::string found_words(const FoundResult& found);

// All rungs of that aim as rungs of a sweep, those that were not timed included.
SweepResult as_sweep(const FoundResult& found, Aim aim);

// The same of the rungs of a sweep, whose own scene is never one.
bool plainly_visible(const SweepResult& sweep, std::size_t rung);

// Tables for a terminal: what changes no pixel, what is cheaper, what would be better.
std::string found_text(const FoundResult& found);
// `plot`: the name of the plot's file; may be empty.
std::string found_markdown(const FoundResult& found, const std::string& plot);
std::string found_html(const FoundResult& found);
nlohmann::ordered_json found_json(const FoundResult& found);

// Reports of several machines side by side: which conclusions hold on all of them.

struct NamedReport {
    std::string name;  // of its file
    std::string json;  // as json_text() wrote it
};

// For each ladder that at least two reports have, a table of the rungs' costs on each machine. Scenes are matched by
// their files' names, or by their paths if one report has several scenes of that name. Marks each rung whose standing
// or saving differs between machines whose measurements are trusted; those of pictures of different sizes are only
// listed. The text is printable. Returns nullopt and sets `error` if a report cannot be read, or no ladder is in two of
// them.
std::optional<std::string> merged_text(std::span<const NamedReport> reports, std::string& error);

}  // namespace snell::accuracy
