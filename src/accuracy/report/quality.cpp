#include "src/accuracy/report/quality.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/content/text_forms.h"

namespace snell::accuracy {

namespace {

using Json = nlohmann::ordered_json;
constexpr int quality_schema = 1;

}  // namespace

std::array<Wish, 3> quality_wishes() {
    constexpr double step = 1.0 / 255;
    return {Wish{}, Wish{.alone = step}, Wish{.alone = step / 100}};
}

std::vector<Preset> presets_of(const Scene& scene, const Counsel& counsel) {
    std::vector<Preset> presets;
    for (std::size_t i = 0; i < counsel.advice.size(); ++i) {
        const Advice& advice = counsel.advice[i];
        const SweepResult& sweep = counsel.sweeps[advice.sweep];
        const RungResult& rung = sweep.rungs[advice.rung];
        presets.push_back({.name = std::string(quality_names.at(i)),
                           .choices = choices(scene, sweep.sweep.rungs[advice.rung].variant.rungs),
                           .rmse = rung.own.light.rmse,
                           .alone = rung.alone.rmse,
                           .milliseconds = rung.milliseconds,
                           .ratio = rung.ratio,
                           .settled = advice.settled,
                           .trusted = sweep.trusted()});
    }
    return presets;
}

std::string quality_json(const Circumstances& where, const std::vector<Preset>& presets) {
    Json json{{"schema", quality_schema},   {"tool", where.tool}, {"date", where.date},
              {"renderer", where.renderer}, {"cpu", where.cpu},   {"size", {where.width, where.height}}};
    for (const Preset& preset : presets) {
        json["presets"][preset.name] = {{"ladders", preset.choices},         {"rmse", number(preset.rmse)},
                                        {"alone", number(preset.alone)},     {"ms", number(preset.milliseconds)},
                                        {"ratio", ratio_text(preset.ratio)}, {"settled", preset.settled},
                                        {"trusted", preset.trusted}};
    }
    return content::json_text(json) + "\n";
}

std::optional<StoredPreset> read_quality(std::string_view text, std::string_view name, std::string& error) {
    const Json json = content::parse_json(text);
    if (!json.is_object() || json.value("schema", Json()) != quality_schema) {
        error = "the file was written by another version of snell; measure again with 'snell accuracy --save-quality'";
        return std::nullopt;
    }
    try {
        const Json& preset = json.at("presets").at(std::string(name));
        StoredPreset stored{preset.at("ladders").get<std::vector<std::string>>(), {}};
        stored.measured =
            fmt::format("RMSE {:.2g}, {} times the scene's own time on {}{}", preset.at("rmse").get<double>(),
                        preset.at("ratio").get<std::string>(), json.at("renderer").get<std::string>(),
                        !preset.at("trusted").get<bool>()   ? ", but there were too few rounds to be certain"
                        : !preset.at("settled").get<bool>() ? "; better combinations may exist"
                                                            : "");
        return stored;
    } catch (const Json::exception& problem) {
        error = problem.what();
        return std::nullopt;
    }
}

}  // namespace snell::accuracy
