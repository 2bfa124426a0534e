#include "src/app/batch/reports.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/app/open/complain.h"
#include "src/content/json.h"

namespace snell::app {

namespace {

using Json = nlohmann::ordered_json;

Json value_json(const AxisValue& value) { return value.number ? Json(*value.number) : Json(value.written); }

Json axis_json(const Axis& axis) {
    Json values = Json::array();
    for (const AxisValue& value : axis.values) values.push_back(value_json(value));
    return {{"name", axis.name}, {"values", std::move(values)}};
}

}  // namespace

bool write_json(const std::string& path, const Json& json) {
    return write_output(path, content::json_text(json) + '\n');
}

Json pictures_json(const Batch& batch, const RenderOptions& options, const Shots& shots, Shard shard) {
    Json json{{"schema", 1}};
    json["scenes"] = shots.scenes;
    json["results"] = Json::array();
    for (const SceneResult& result : batch.results())
        json["results"].push_back({{"scene", shots.scenes[result.scene]},
                                   {"status", result.drawn ? result.errors > 0 ? "errors" : "fine" : "not drawn"},
                                   {"errors", result.errors},
                                   {"warnings", result.warnings}});
    json["axes"] = Json::array();
    for (const Axis& axis : shots.axes) json["axes"].push_back(axis_json(axis));
    json["total"] = shots.files.size();
    json["shard"] = {{"index", shard.index}, {"count", shard.count}};
    json["samples"] = options.samples;
    json["set"] = options.sets;
    json["ladder"] = options.ladders;
    json["renderer"] = batch.caps().renderer;
    json["gl"] = batch.caps().version;
    json["pictures"] = Json::array();
    for (std::size_t i = 0; i < batch.records().size(); ++i) {
        const Record& record = batch.records()[i];
        const Written& written = batch.written()[i];
        Json values = Json::object();
        for (std::size_t axis = 0; axis < shots.axes.size(); ++axis)
            values[shots.axes[axis].name] = value_json(shots.value(record.shot, axis));
        Json picture{{"index", record.shot.index},  {"scene", shots.scenes[record.shot.scene]},
                     {"values", std::move(values)}, {"file", shots.files[record.shot.index]},
                     {"bytes", written.bytes},      {"sha256", written.sha256}};
        if (record.skipped) picture["skipped"] = true;
        if (!record.skipped) picture["time"] = record.time;
        if (!record.skipped) picture["milliseconds"] = record.milliseconds;
        if (!written.error.empty()) picture["error"] = written.error;
        json["pictures"].push_back(std::move(picture));
    }
    return json;
}

Json Batch::stats() const {
    const Counters& c = last_->runtime->counters();
    Json json{{"schema", 1}};
    json["scene"] = shots_.scenes.front();
    json["output"] = options_.output;
    json["size"] = {target_.width, target_.height};
    json["samples"] = target_.samples;
    json["time"] = options_.time;
    json["renderer"] = caps_.renderer;
    json["gl"] = caps_.version;
    json["glsl"] = caps_.glsl;
    json["pictures"] = records_.size();
    json["milliseconds"] = {
        {"context", timings_.context}, {"load", timings_.load}, {"frame", timings_.frame}, {"write", timings_.write}};
    if (non_finite_) json["non_finite"] = {{"nan", non_finite_->nan}, {"infinite", non_finite_->infinite}};
    json["errors"] = last_->diagnostics.errors();
    json["warnings"] = last_->diagnostics.warnings();
    for (const CounterName& counter : counter_names()) json["counters"][std::string(counter.name)] = c.*counter.value;
    return json;
}

}  // namespace snell::app
