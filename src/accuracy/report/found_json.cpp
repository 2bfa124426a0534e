// Rungs that were found, for other programs.
#include <cmath>
#include <nlohmann/json.hpp>

#include "src/accuracy/report/found.h"
#include "src/accuracy/report/numbers.h"
#include "src/document/view_text.h"

namespace snell::accuracy {

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
    constexpr std::array<std::string_view, 3> aims{"cheaper", "better", "unused"},
        outcomes{"tried", "refused", "not tried"};
    FoundJson json{{"rung", rung.name},
                   {"aim", aims[static_cast<std::size_t>(rung.aim)]},
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
    if (const RungResult* times = found.times(rung)) {
        json["n_rounds"] = times->rounds;
        json["ms"] = interval_json({times->low, times->milliseconds, times->high});
        json["ratio_to_scene"] = interval_json(times->ratio);
        json["cost"] = name(found.sweep_of(rung).costs.of(*rung.timed, found.sweep_of(rung).sweep.current));
    }
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
