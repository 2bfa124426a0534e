#include "src/app/open/quality.h"

#include <fmt/format.h>

#include <filesystem>

#include "src/accuracy/report/quality.h"
#include "src/content/replace.h"

namespace snell::app {

std::string quality_path(const std::string& scene) {
    return std::filesystem::path(scene).replace_extension(".quality.json").string();
}

bool choose_quality(const std::string& path, const std::string& name, const Scene& scene, Rungs& rungs,
                    Diagnostics& diagnostics) {
    if (scene.ladders.empty()) {
        fmt::print(stderr, "snell: quality {}: '{}' has no ladders, nothing is chosen\n", name, path);
        return true;
    }
    const std::string file = quality_path(path);
    const std::string remedy = fmt::format("measure it: snell accuracy {} --save-quality", path);
    if (std::error_code none; !std::filesystem::exists(file, none)) {
        diagnostics.error("no-quality", fmt::format("there is no '{}'", file), remedy);
        return false;
    }
    std::string why;
    const auto preset = accuracy::read_quality(content::whole_file(file), name, why);
    if (!preset) {
        diagnostics.error("bad-quality", fmt::format("'{}' cannot be used: {}", file, why), remedy);
        return false;
    }
    Diagnostics changed;
    bool good = preset->choices.size() == rungs.size();
    for (const std::string& choice : preset->choices) good = good && choose_rung(rungs, scene, choice, changed);
    if (!good) {
        diagnostics.error("stale-quality", fmt::format("'{}' is of other ladders than the scene has", file), remedy);
        return false;
    }
    fmt::print(stderr, "snell: quality {}: {} ({})\n", name, fmt::join(preset->choices, " "), preset->measured);
    return true;
}

}  // namespace snell::app
