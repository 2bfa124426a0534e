// Quality presets of a scene: the rung of every ladder for each of a few wishes, as found by measurement. Values and
// JSON; no files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/advice.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

inline constexpr std::array<std::string_view, 3> quality_names{"fast", "balanced", "exact"};

// The wishes of the presets. fast: the cheapest combination of all. balanced: the cheapest whose picture differs from
// that of the last rungs by an RMSE of less than 1/255. exact: by less than a hundredth of that. Finer samples and
// meshes are no matter of rungs, so these are compared at the scene's own.
std::array<Wish, 3> quality_wishes();

struct Preset {
    std::string name;
    std::vector<std::string> choices;  // "A=x" for each ladder
    double rmse = 0;                   // compared with the reference
    double alone = 0;                  // compared with the last rungs at the scene's knobs
    double milliseconds = 0;
    Interval ratio{1, 1, 1};  // relative to the scene's rungs at the time of measurement
    bool settled = false;     // no measured combination fulfils the wish better
    bool trusted = false;     // there were rounds enough
};

// Makes the presets from the results of advise() for quality_wishes().
std::vector<Preset> presets_of(const Scene& scene, const Counsel& counsel);

std::string quality_json(const Circumstances& where, const std::vector<Preset>& presets);

struct StoredPreset {
    std::vector<std::string> choices;
    std::string measured;  // such as "RMSE 0.0031, 1.20 [1.10, 1.31] times the scene's own time on llvmpipe"
};
// Reads a preset from a file that quality_json wrote. Returns nullopt and sets `error` if it is not such a file.
std::optional<StoredPreset> read_quality(std::string_view json, std::string_view name, std::string& error);

}  // namespace snell::accuracy
