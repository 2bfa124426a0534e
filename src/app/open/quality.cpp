#include "src/app/open/quality.h"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/quality.h"

namespace snell::app {

namespace {

// Returns nullopt and reports an error if there is no such preset for these ladders.
std::optional<accuracy::StoredPreset> choose_preset(const std::string& path, const std::string& name,
                                                    const Access& access, const Scene& scene, Rungs& rungs,
                                                    Diagnostics& diagnostics) {
    const std::string file = quality_path(path);
    const std::string remedy = fmt::format("measure it: snell accuracy {} --save-quality", path);
    if (std::error_code none; !std::filesystem::exists(file, none)) {
        diagnostics.error("no-quality", fmt::format("there is no '{}'", file), remedy);
        return std::nullopt;
    }
    std::string why;
    const auto text = Files(std::filesystem::path(path).parent_path().string(), access).read(file, why);
    const auto preset = text ? accuracy::read_quality(*text, name, why) : std::nullopt;
    if (!preset) {
        diagnostics.error("bad-quality", fmt::format("'{}' cannot be used: {}", file, why), remedy);
        return std::nullopt;
    }
    Diagnostics changed;
    bool good = preset->choices.size() == rungs.size();
    for (const std::string& choice : preset->choices) good = good && choose_rung(rungs, scene, choice, changed);
    if (good) return preset;
    diagnostics.error("stale-quality", fmt::format("'{}' is of other ladders than the scene has", file), remedy);
    return std::nullopt;
}

// The preset's costs are of its own rungs, which are named if others are drawn.
void print_rungs(const RungWishes& wishes, const Scene& scene, const accuracy::StoredPreset& preset,
                 const Rungs& measured, const Rungs& drawn) {
    std::vector<std::string> choices = accuracy::choices(scene, drawn);
    bool other = drawn != measured;
    for (std::size_t i = 0; i < choices.size(); ++i)
        if (ranges::find(wishes.swept, scene.ladders[i].name) != wishes.swept.end()) {
            choices[i] = scene.ladders[i].name + " varies";
            other = true;
        }
    const std::string with =
        other ? fmt::format("measured with {}: ", fmt::join(accuracy::choices(scene, measured), " ")) : "";
    fmt::print(stderr, "snell: quality {}: {} ({}{})\n", wishes.quality, fmt::join(choices, " "), with,
               utf8::printable(preset.measured));
}

}  // namespace

std::string quality_path(const std::string& scene) {
    return std::filesystem::path(scene).replace_extension(".quality.json").string();
}

void choose_rungs(const std::string& path, const RungWishes& wishes, const Access& access, const Scene& scene,
                  Rungs& rungs, Diagnostics& diagnostics) {
    std::optional<accuracy::StoredPreset> preset;
    if (!wishes.quality.empty() && scene.ladders.empty())
        fmt::print(stderr, "snell: quality {}: '{}' has no ladders, nothing is chosen\n", wishes.quality,
                   utf8::printable(path));
    else if (!wishes.quality.empty())
        preset = choose_preset(path, wishes.quality, access, scene, rungs, diagnostics);
    const Rungs measured = rungs;
    for (const std::string& ladder : wishes.ladders) choose_rung(rungs, scene, ladder, diagnostics);
    if (preset) print_rungs(wishes, scene, *preset, measured, rungs);
}

}  // namespace snell::app
