// Results of measurements for other programs: CSV and JSON.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "src/accuracy/report.h"
#include "src/content/json.h"

namespace snell::accuracy {

namespace {

using Json = nlohmann::ordered_json;

// JSON has no infinity; null stands for it.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::vector<double> present(const std::vector<double>& times) {
    std::vector<double> result;
    for (double t : times)
        if (t > 0) result.push_back(t);
    return result;
}

Interval interval(const std::vector<double>& times) {
    const std::vector<double> values = present(times);
    return values.empty() ? Interval{} : bootstrap_median(values);
}

Json error_json(const Error& error) {
    return {{"rmse", number(error.rmse)},
            {"psnr_db", number(error.psnr)},
            {"max_abs", number(error.max)},
            {"mean_abs", number(error.mean)},
            {"correlation", number(error.correlation)},
            {"pixels", error.pixels},
            {"nonfinite", error.nonfinite}};
}

Json rung_json(const SweepResult& sweep, const RungResult& rung, std::size_t index) {
    Json json{{"rung", rung.name},
              {"is_reference", index == sweep.sweep.reference},
              {"is_current", index == sweep.sweep.current},
              {"drawn", rung.drawn}};
    if (!rung.drawn) return json;
    if (sweep.sweep.kind == SweepKind::lattice) json["steps"] = rung.steps;
    json["n_rounds"] = rung.rounds;
    if (rung.rounds > 0) {
        json["ms"] = {{"median", number(rung.milliseconds)}, {"lo95", number(rung.low)}, {"hi95", number(rung.high)}};
        json["ratio_to_current"] = {
            {"median", number(rung.ratio.middle)}, {"lo95", number(rung.ratio.low)}, {"hi95", number(rung.ratio.high)}};
        json["cpu_ms"] = present(rung.cpu);
        json["wall_ms"] = present(rung.wall);
        if (!present(rung.gpu).empty()) json["gpu_ms"] = present(rung.gpu);
    }
    json["own"] = error_json(rung.own);
    json["whole"] = error_json(rung.whole);
    json["flip_mean"] = number(rung.flip);
    if (rung.degrees)
        json["degrees"] = {{"mean", rung.degrees->mean}, {"p99", rung.degrees->p99}, {"max", rung.degrees->max}};
    json["saturated"] = rung.saturated;
    json["below_residual"] = rung.below_residual;
    json["cliff"] = rung.cliff;
    json["standing"] = standing_text(sweep, rung);
    return json;
}

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{:.6g}", value) : ""; }

// Commas and quotes would end a cell, so they are replaced.
std::string cell(std::string text) {
    for (char& c : text)
        if (c == ',' || c == '"' || c == '\n') c = ' ';
    return text;
}

constexpr std::string_view columns =
    "scene,ladder,rung,is_reference,is_current,from,tuple,n_rounds,clock,ms_median,ms_mad,ms_lo95,ms_hi95,ratio,"
    "ratio_lo95,ratio_hi95,cpu_ms_median,cpu_lo95,cpu_hi95,cpu_cv,wall_ms_median,wall_cv,gpu_ms_median,"
    "aa_control_ratio,aa_control_lo95,aa_control_hi95,noisy,rmse,psnr_db,max_abs,mean_abs,rmse_whole,psnr_whole_db,"
    "mask_pixels,nonfinite,correlation,flip_mean,deg_mean,deg_p99,deg_max,saturated,cliff,ref_residual,on_front,"
    "standing,machine,cores,os,renderer,gl,width,height,reps,date,load_before,load_after";

std::string row(const Report& report, const SweepResult& sweep, std::size_t index) {
    const RungResult& rung = sweep.rungs[index];
    const Circumstances& w = report.where;
    const std::vector<double> cpu = present(rung.cpu), wall = present(rung.wall), gpu = present(rung.gpu);
    const std::vector<double>& clock = sweep.clock == ClockKind::cpu ? cpu : sweep.clock == ClockKind::gpu ? gpu : wall;
    const Interval cpu_interval = interval(rung.cpu);
    const bool timed = rung.rounds > 0;
    const auto when = [](bool known, double value) { return known ? cell(value) : std::string(); };
    const bool front = sweep.trusted() && timed && rung.verdict.standing == Standing::front;
    const std::vector<std::string> cells{cell(w.scene),
                                         cell(sweep.sweep.name),
                                         cell(rung.name),
                                         index == sweep.sweep.reference ? "1" : "0",
                                         index == sweep.sweep.current ? "1" : "0",
                                         w.from,
                                         fmt::format("{}", fmt::join(rung.steps, " ")),
                                         std::to_string(rung.rounds),
                                         std::string(name(sweep.clock)),
                                         when(timed, rung.milliseconds),
                                         when(timed, mad(clock)),
                                         when(timed, rung.low),
                                         when(timed, rung.high),
                                         when(timed, rung.ratio.middle),
                                         when(timed, rung.ratio.low),
                                         when(timed, rung.ratio.high),
                                         when(timed, cpu_interval.middle),
                                         when(timed, cpu_interval.low),
                                         when(timed, cpu_interval.high),
                                         when(timed, variation(cpu)),
                                         when(timed, median(wall)),
                                         when(timed, variation(wall)),
                                         when(!gpu.empty(), median(gpu)),
                                         cell(sweep.control.ratio.middle),
                                         cell(sweep.control.ratio.low),
                                         cell(sweep.control.ratio.high),
                                         sweep.trusted() ? "0" : "1",
                                         when(rung.drawn, rung.own.rmse),
                                         when(rung.drawn, rung.own.psnr),
                                         when(rung.drawn, rung.own.max),
                                         when(rung.drawn, rung.own.mean),
                                         when(rung.drawn, rung.whole.rmse),
                                         when(rung.drawn, rung.whole.psnr),
                                         std::to_string(sweep.own_pixels),
                                         std::to_string(rung.whole.nonfinite),
                                         when(rung.drawn, rung.own.correlation),
                                         when(rung.drawn, rung.flip),
                                         when(rung.degrees.has_value(), rung.degrees ? rung.degrees->mean : 0),
                                         when(rung.degrees.has_value(), rung.degrees ? rung.degrees->p99 : 0),
                                         when(rung.degrees.has_value(), rung.degrees ? rung.degrees->max : 0),
                                         rung.saturated ? "1" : "0",
                                         rung.cliff ? "1" : "0",
                                         when(sweep.residual.has_value(), sweep.residual.value_or(0)),
                                         front ? "1" : "0",
                                         cell(standing_text(sweep, rung)),
                                         cell(w.cpu),
                                         std::to_string(w.cores),
                                         cell(w.os),
                                         cell(w.renderer),
                                         cell(w.gl),
                                         std::to_string(w.width),
                                         std::to_string(w.height),
                                         std::to_string(w.rounds),
                                         w.date,
                                         cell(w.load_before),
                                         cell(w.load_after)};
    return fmt::format("{}", fmt::join(cells, ","));
}

}  // namespace

std::string csv_text(const Report& report) {
    std::string text(columns);
    text += '\n';
    for (const SweepResult& sweep : report.sweeps)
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) text += row(report, sweep, i) + '\n';
    return text;
}

std::string json_text(const Report& report) {
    const Circumstances& w = report.where;
    Json json{{"schema", 1},
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
              {"query_over_wall", w.query_over_wall > 0 ? Json(w.query_over_wall) : Json(nullptr)},
              {"warnings", report.problems}};
    json["ladders"] = Json::array();
    for (const SweepResult& sweep : report.sweeps) {
        const char* kind = sweep.sweep.kind == SweepKind::ladder ? "ladder"
                           : sweep.sweep.kind == SweepKind::knob ? "knob"
                                                                 : "lattice";
        Json one{{"scene", sweep.scene},
                 {"ladder", sweep.sweep.name},
                 {"kind", kind},
                 {"clock", name(sweep.clock)},
                 {"metric", sweep.metric == Metric::degrees ? "degrees" : "rmse"},
                 {"mask_pixels", sweep.own_pixels},
                 {"interrupted", sweep.interrupted},
                 {"trusted", sweep.trusted()},
                 {"words", in_words(sweep)}};
        one["aa_control"] = {{"ratio", number(sweep.control.ratio.middle)},
                             {"lo95", number(sweep.control.ratio.low)},
                             {"hi95", number(sweep.control.ratio.high)},
                             {"noisy", sweep.control.noisy}};
        one["reference"] = {{"rung", sweep.rungs[sweep.sweep.reference].name},
                            {"residual", sweep.residual ? number(*sweep.residual) : Json(nullptr)},
                            {"note", sweep.residual_note}};
        one["front"] = Json::array();
        one["rungs"] = Json::array();
        for (std::size_t i = 0; i < sweep.rungs.size(); ++i) {
            if (sweep.trusted() && sweep.rungs[i].rounds > 0 && sweep.rungs[i].verdict.standing == Standing::front)
                one["front"].push_back(sweep.rungs[i].name);
            one["rungs"].push_back(rung_json(sweep, sweep.rungs[i], i));
        }
        json["ladders"].push_back(std::move(one));
    }
    return content::json_text(json) + "\n";
}

}  // namespace snell::accuracy
