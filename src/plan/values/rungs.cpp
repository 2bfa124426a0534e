#include "src/plan/values/rungs.h"

#include <fmt/format.h>

#include "parser/text/ranges.h"

namespace snell {
namespace {

std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& names) {
    const std::string_view near = nearest(word, names);
    if (!near.empty()) return fmt::format("did you mean '{}'?", near);
    return names.empty() ? "" : fmt::format("available: {}", fmt::join(names, ", "));
}

}  // namespace

Rungs marked_rungs(const Scene& scene) {
    Rungs rungs;
    for (const Ladder& ladder : scene.ladders) rungs.push_back(ladder.current);
    return rungs;
}

std::vector<glsl::Define> ladder_defines(std::span<const Ladder> ladders, const Rungs& rungs) {
    std::vector<glsl::Define> defines;
    for (size_t i = 0; i < ladders.size() && i < rungs.size(); ++i) {
        const Ladder& ladder = ladders[i];
        for (size_t rung = 0; rung < ladder.rungs.size(); ++rung)
            defines.push_back({ladder.name + "_" + ladder.rungs[rung], std::to_string(rung)});
        defines.push_back({ladder.name, std::to_string(rungs[i])});
        if (ladder.numeric()) defines.push_back({ladder.name + "_VALUE", ladder.rungs[rungs[i]]});
    }
    return defines;
}

bool choose_rung(Rungs& rungs, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = assignment.substr(0, equals);
    if (equals == std::string_view::npos || name.empty()) {
        diagnostics.error("bad-assignment", fmt::format("'{}' is not a choice of a rung", assignment),
                          "write LADDER=rung");
        return false;
    }
    const auto ladder = ranges::find(scene.ladders, name, &Ladder::name);
    if (ladder == scene.ladders.end()) {
        std::vector<std::string_view> names;
        for (const Ladder& other : scene.ladders) names.push_back(other.name);
        diagnostics.error("unknown-ladder",
                          names.empty() ? fmt::format("there is no ladder '{}': the scene has no ladders", name)
                                        : fmt::format("there is no ladder '{}'", name),
                          did_you_mean(name, names));
        return false;
    }
    const std::string_view wanted = assignment.substr(equals + 1);
    const auto rung = ranges::find(ladder->rungs, wanted);
    if (rung == ladder->rungs.end()) {
        diagnostics.error("unknown-rung", fmt::format("ladder '{}' has no rung '{}'", name, wanted),
                          did_you_mean(wanted, {ladder->rungs.begin(), ladder->rungs.end()}));
        return false;
    }
    rungs[static_cast<std::size_t>(ladder - scene.ladders.begin())] =
        static_cast<std::size_t>(rung - ladder->rungs.begin());
    return true;
}

void carry_over(const Rungs& from, const Scene& from_scene, Rungs& to, const Scene& to_scene) {
    if (from.size() != from_scene.ladders.size()) return;
    for (std::size_t i = 0; i < to.size(); ++i) {
        const Ladder& ladder = to_scene.ladders[i];
        const auto old = ranges::find(from_scene.ladders, ladder.name, &Ladder::name);
        if (old == from_scene.ladders.end() || old->rungs[old->current] != ladder.rungs[ladder.current]) continue;
        const std::string& chosen = old->rungs[from[static_cast<std::size_t>(old - from_scene.ladders.begin())]];
        const auto rung = ranges::find(ladder.rungs, chosen);
        if (rung != ladder.rungs.end()) to[i] = static_cast<std::size_t>(rung - ladder.rungs.begin());
    }
}

}  // namespace snell
