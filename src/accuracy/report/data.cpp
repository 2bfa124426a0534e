// Results of measurements for other programs: CSV and JSON.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <concepts>
#include <nlohmann/json.hpp>
#include <optional>

#include "src/accuracy/report/report.h"
#include "src/content/text_forms.h"

namespace snell::accuracy {

namespace {

using Json = nlohmann::ordered_json;

Interval interval(const std::vector<double>& times) { return median_interval(taken(times)); }

Json rung_json(const SweepResult& sweep, const RungResult& rung, std::size_t index) {
    Json json{{"rung", rung.name},
              {"is_reference", index == sweep.sweep.reference},
              {"is_current", index == sweep.sweep.current},
              {"drawn", rung.drawn}};
    if (!rung.drawn) return json;
    if (sweep.sweep.kind == SweepKind::lattice) json["steps"] = rung.steps;
    json["n_rounds"] = rung.rounds;
    if (rung.rounds > 0) {
        add_times(json, sweep, index, "ratio_to_current");
        json["cpu_ms"] = taken(rung.cpu);
        json["wall_ms"] = taken(rung.wall);
        if (!taken(rung.gpu).empty()) json["gpu_ms"] = taken(rung.gpu);
    }
    json["own"] = error_json(rung.own);
    json["whole"] = error_json(rung.whole);
    json["alone"] = figures_json(rung.alone);
    if (rung.elsewhere) json["elsewhere"] = figures_json(*rung.elsewhere);
    json["hidden"] = rung.hidden();
    json["flip_mean"] = number(rung.flip);
    if (const auto& degrees = rung.degrees)
        json["degrees"] = {
            {"mean", number(degrees->mean)}, {"p99", number(degrees->p99)}, {"max", number(degrees->max)}};
    json["saturated"] = rung.saturated;
    json["below_residual"] = rung.below_residual;
    json["cliff"] = rung.cliff;
    json["standing"] = standing_text(sweep, rung);
    return json;
}

std::string cell(double value) { return std::isnan(value) ? "" : fmt::format("{:.6g}", value); }

std::string cell(std::string_view words) { return std::string(words); }
// The ends of an interval; empty if it is not known.
std::string low_cell(const Interval& of) { return of.known() ? cell(of.low) : ""; }
std::string high_cell(const Interval& of) { return of.known() ? cell(of.high) : ""; }
std::string cell(std::integral auto value) { return std::to_string(value); }

struct Row {
    const Circumstances& where;
    const SweepResult& sweep;
    std::size_t index;
    // Of a rung that was found; its sweep has other rungs than those that were timed together.
    std::string place = {}, change = {};
    std::optional<std::string> found_standing = {};
    std::array<int, 2> pictures{where.width, where.height}, frames = pictures;  // that were compared; that were timed
    const RungResult& rung = sweep.rungs[index];
    bool timed() const { return rung.rounds > 0; }
    std::string standing() const { return found_standing ? *found_standing : standing_text(sweep, rung); }
    const std::vector<double>& times() const { return rung.times(sweep.clock); }
};

struct Column {
    std::string_view name;
    std::string (*value)(const Row&);
    enum class When : std::uint8_t { always, drawn, timed } when = When::always;  // otherwise the cell is empty
    content::CellKind kind = content::CellKind::number;
};

constexpr auto always = Column::When::always, drawn = Column::When::drawn, timed = Column::When::timed;
constexpr auto words = content::CellKind::words;
constexpr Column columns[]{
    {"scene", [](const Row& r) { return cell(r.sweep.scene); }, always, words},
    {"ladder", [](const Row& r) { return cell(r.sweep.sweep.name); }, always, words},
    {"rung", [](const Row& r) { return cell(r.rung.name); }, always, words},
    {"is_reference", [](const Row& r) { return cell(r.index == r.sweep.sweep.reference); }},
    {"is_current", [](const Row& r) { return cell(r.index == r.sweep.sweep.current); }},
    {"from", [](const Row& r) { return cell(r.where.from); }, always, words},
    {"tuple", [](const Row& r) { return fmt::format("{}", fmt::join(r.rung.steps, " ")); }},
    {"n_rounds", [](const Row& r) { return cell(r.rung.rounds); }},
    {"clock", [](const Row& r) { return cell(name(r.sweep.clock)); }, timed, words},
    {"ms_median", [](const Row& r) { return cell(r.rung.milliseconds); }, timed},
    {"ms_mad", [](const Row& r) { return cell(mad(taken(r.times()))); }, timed},
    {"ms_lo95", [](const Row& r) { return low_cell(interval(r.times())); }, timed},
    {"ms_hi95", [](const Row& r) { return high_cell(interval(r.times())); }, timed},
    {"ratio", [](const Row& r) { return cell(r.rung.ratio.middle); }, timed},
    {"ratio_lo95", [](const Row& r) { return low_cell(r.rung.ratio); }, timed},
    {"ratio_hi95", [](const Row& r) { return high_cell(r.rung.ratio); }, timed},
    {"cpu_ms_median", [](const Row& r) { return cell(interval(r.rung.cpu).middle); }, timed},
    {"cpu_lo95", [](const Row& r) { return low_cell(interval(r.rung.cpu)); }, timed},
    {"cpu_hi95", [](const Row& r) { return high_cell(interval(r.rung.cpu)); }, timed},
    {"cpu_cv", [](const Row& r) { return cell(variation(taken(r.rung.cpu))); }, timed},
    {"wall_ms_median", [](const Row& r) { return cell(median(taken(r.rung.wall))); }, timed},
    {"wall_cv", [](const Row& r) { return cell(variation(taken(r.rung.wall))); }, timed},
    {"gpu_ms_median", [](const Row& r) { return cell(median(taken(r.rung.gpu))); }, timed},
    {"aa_control_ratio", [](const Row& r) { return cell(r.sweep.control.ratio.middle); }, timed},
    {"aa_control_lo95", [](const Row& r) { return low_cell(r.sweep.control.ratio); }, timed},
    {"aa_control_hi95", [](const Row& r) { return high_cell(r.sweep.control.ratio); }, timed},
    {"noisy", [](const Row& r) { return cell(!r.sweep.trusted()); }, timed},
    {"rmse_light", [](const Row& r) { return cell(r.rung.own.light.rmse); }, drawn},
    {"psnr_light_db", [](const Row& r) { return cell(r.rung.own.light.psnr); }, drawn},
    {"max_abs_light", [](const Row& r) { return cell(r.rung.own.light.max); }, drawn},
    {"mean_abs_light", [](const Row& r) { return cell(r.rung.own.light.mean); }, drawn},
    {"rmse_display", [](const Row& r) { return cell(r.rung.own.display.rmse); }, drawn},
    {"psnr_display_db", [](const Row& r) { return cell(r.rung.own.display.psnr); }, drawn},
    {"rmse_whole_light", [](const Row& r) { return cell(r.rung.whole.light.rmse); }, drawn},
    {"psnr_whole_light_db", [](const Row& r) { return cell(r.rung.whole.light.psnr); }, drawn},
    {"rmse_alone_light", [](const Row& r) { return cell(r.rung.alone.rmse); }, drawn},
    {"rmse_elsewhere_light", [](const Row& r) { return r.rung.elsewhere ? cell(r.rung.elsewhere->rmse) : ""; }, drawn},
    {"hidden", [](const Row& r) { return cell(r.rung.hidden()); }, drawn},
    {"mask_pixels", [](const Row& r) { return cell(r.sweep.own_pixels); }},
    {"nonfinite", [](const Row& r) { return cell(r.rung.whole.nonfinite); }},
    {"correlation", [](const Row& r) { return cell(r.rung.own.correlation); }, drawn},
    {"flip_mean", [](const Row& r) { return cell(r.rung.flip); }, drawn},
    {"deg_mean", [](const Row& r) { return r.rung.degrees ? cell(r.rung.degrees->mean) : ""; }, drawn},
    {"deg_p99", [](const Row& r) { return r.rung.degrees ? cell(r.rung.degrees->p99) : ""; }, drawn},
    {"deg_max", [](const Row& r) { return r.rung.degrees ? cell(r.rung.degrees->max) : ""; }, drawn},
    {"saturated", [](const Row& r) { return cell(r.rung.saturated); }},
    {"cliff", [](const Row& r) { return cell(r.rung.cliff); }},
    {"ref_residual", [](const Row& r) { return r.sweep.residual ? cell(*r.sweep.residual) : ""; }},
    {"below_residual", [](const Row& r) { return cell(r.rung.below_residual); }, drawn},
    {"on_front",
     [](const Row& r) { return cell(r.found_standing ? *r.found_standing == "front" : r.sweep.on_front(r.rung)); }},
    {"standing", [](const Row& r) { return cell(r.standing()); }, always, words},
    {"cannot_say", [](const Row& r) { return cell(r.sweep.cannot_say); }, always, words},
    {"machine", [](const Row& r) { return cell(r.where.cpu); }, always, words},
    {"cores", [](const Row& r) { return cell(r.where.cores); }},
    {"os", [](const Row& r) { return cell(r.where.os); }, always, words},
    {"renderer", [](const Row& r) { return cell(r.where.renderer); }, always, words},
    {"gl", [](const Row& r) { return cell(r.where.gl); }, always, words},
    {"width", [](const Row& r) { return cell(r.pictures[0]); }},
    {"height", [](const Row& r) { return cell(r.pictures[1]); }},
    {"reps", [](const Row& r) { return cell(r.where.rounds); }},
    {"date", [](const Row& r) { return cell(r.where.date); }, always, words},
    {"load_before", [](const Row& r) { return cell(r.where.load_before); }},
    {"load_after", [](const Row& r) { return cell(r.where.load_after); }},
    {"place", [](const Row& r) { return cell(std::string_view(r.place)); }, always, words},
    {"change", [](const Row& r) { return cell(std::string_view(r.change)); }, always, words},
    {"ms_width", [](const Row& r) { return cell(r.frames[0]); }, timed},
    {"ms_height", [](const Row& r) { return cell(r.frames[1]); }, timed},
};

void add_row(content::Table& table, const Row& row) {
    auto& cells = table.rows.emplace_back().cells;
    for (const Column& column : columns) {
        const bool known = column.when == Column::When::always || (column.when == drawn && row.rung.drawn) ||
                           (column.when == timed && row.timed());
        cells.push_back(known ? column.value(row) : std::string());
    }
}

Json sweep_json(const SweepResult& sweep) {
    const char* kind = sweep.sweep.kind == SweepKind::ladder ? "ladder"
                       : sweep.sweep.kind == SweepKind::knob ? "knob"
                                                             : "lattice";
    Json json{{"scene", sweep.scene},
              {"ladder", sweep.sweep.name},
              {"kind", kind},
              {"clock", name(sweep.clock)},
              {"metric", sweep.metric == Metric::degrees ? "degrees" : "rmse"},
              {"mask_pixels", sweep.own_pixels},
              {"interrupted", sweep.interrupted},
              {"trusted", sweep.trusted()},
              {"cannot_say", sweep.cannot_say},
              {"words", in_words(sweep)}};
    const Json control = interval_json(sweep.control.ratio);
    json["aa_control"] = {{"ratio", control["median"]},
                          {"lo95", control["lo95"]},
                          {"hi95", control["hi95"]},
                          {"noise", number(sweep.control.noise)}};
    json["family_level"] = family_level;
    json["reference"] = {{"rung", sweep.rungs[sweep.sweep.reference].name},
                         {"samples", sweep.finest.grid},
                         {"tessellation", sweep.finest.plan.tessellation},
                         {"residual", sweep.residual ? number(*sweep.residual) : Json(nullptr)},
                         {"note", sweep.reference_note}};
    json["front"] = Json::array();
    json["rungs"] = Json::array();
    for (std::size_t i = 0; i < sweep.rungs.size(); ++i) {
        if (sweep.on_front(sweep.rungs[i])) json["front"].push_back(sweep.rungs[i].name);
        json["rungs"].push_back(rung_json(sweep, sweep.rungs[i], i));
    }
    return json;
}

}  // namespace

std::string csv_text(const Report& report) {
    content::Table table;
    for (const Column& column : columns) table.columns.push_back({std::string(column.name), column.kind});
    for (const SweepResult& sweep : report.sweeps)
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) add_row(table, {report.where, sweep, i});
    for (const FoundResult& found : report.found)
        for (const Aim aim : {Aim::cheaper, Aim::better, Aim::unused}) {
            const SweepResult listed = as_sweep(found, aim);
            for (std::size_t i = 0; i < listed.rungs.size(); ++i) {
                const FoundRung* rung = found.find(listed.rungs[i].name);
                if (!rung) continue;
                add_row(table, {report.where,
                                listed,
                                i,
                                place_of(found, *rung),
                                change_of(found, *rung),
                                standing_of(found, *rung),
                                {rung->width, rung->height},
                                aim == Aim::cheaper ? found.timed_size : found.costs_size});
            }
        }
    return content::table_csv(table);
}

std::string json_text(const Report& report) {
    const Circumstances& w = report.where;
    Json json{{"schema", report_schema},
              {"tool", w.tool},
              {"date", w.date},
              {"host",
               {{"cpu", w.cpu},
                {"cores", w.cores},
                {"os", w.os},
                {"load_before", w.load_before},
                {"load_after", w.load_after}}},
              {"gl", {{"renderer", w.renderer}, {"vendor", w.vendor}, {"version", w.gl}}},
              {"scene", {{"path", w.scene}, {"size", {w.width, w.height}}, {"time", w.time}, {"sets", w.sets}}},
              {"rounds", w.rounds},
              {"from", w.from},
              {"errors", errors_are},
              {"query_over_wall", w.query_over_wall > 0 ? Json(w.query_over_wall) : Json(nullptr)},
              {"warnings", report.problems}};
    for (const FoundResult& found : report.found) json["found"].push_back(found_json(found));
    json["ladders"] = Json::array();
    for (const SweepResult& sweep : report.sweeps) json["ladders"].push_back(sweep_json(sweep));
    return content::json_text(json) + "\n";
}

}  // namespace snell::accuracy
