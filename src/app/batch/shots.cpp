#include "src/app/batch/shots.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <unordered_map>

#include "parser/text/ranges.h"
#include "src/app/batch/pattern.h"

namespace snell::app {

namespace {

std::optional<std::size_t> whole(std::string_view text) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Each of these returns "" or the error.
std::string check_distinct(const Shots& shots) {
    std::unordered_map<std::string, std::size_t> taken;
    for (std::size_t i = 0; i < shots.files.size(); ++i) {
        const auto [other, is_new] =
            taken.emplace(std::filesystem::path(shots.files[i]).lexically_normal().string(), i);
        if (is_new) continue;
        const Shot first = shots.shot(other->second), second = shots.shot(i);
        if (first.scene != second.scene && first.at == second.at)
            return fmt::format(
                "the pictures of '{}' and '{}' would both be '{}'\n   help: {{path}} in the name tells "
                "scenes apart; {{dir}} is the name of a scene's folder",
                shots.scenes[first.scene], shots.scenes[second.scene], shots.files[i]);
        const auto differs = std::mismatch(first.at.begin(), first.at.end(), second.at.begin(), second.at.end()).first -
                             first.at.begin();
        return fmt::format("pictures {} and {} would both be '{}': {{{}}} or {{index}} in the name tells them apart",
                           first.index, second.index, shots.files[i],
                           shots.axes[static_cast<std::size_t>(differs)].name);
    }
    return {};
}

std::string check_count(const Shots& shots) {
    std::size_t count = shots.scenes.size();
    for (const Axis& axis : shots.axes) {
        if (count > 0 && axis.values.size() > max_pictures / count)
            return fmt::format("these are more than {} pictures, which is the most for one command", max_pictures);
        count *= axis.values.size();
    }
    return {};
}

std::string check_names(const std::vector<Axis>& axes) {
    for (auto axis = axes.begin(); axis != axes.end(); ++axis)
        if (std::any_of(axes.begin(), axis, [&](const Axis& other) { return other.name == axis->name; }))
            return fmt::format("'{}' varies twice", axis->name);
    return {};
}

bool distinct(std::vector<std::string> names) {
    ranges::sort(names);
    return std::adjacent_find(names.begin(), names.end()) == names.end();
}

std::vector<std::string> stems_of(const std::vector<std::string>& scenes) {
    std::vector<std::string> stems;
    for (const std::string& scene : scenes) stems.push_back(std::filesystem::path(scene).stem().string());
    return stems;
}

// Stem, name of the folder, name of the folder above.
std::vector<AxisValue> names_of_scene(const std::string& scene) {
    std::error_code error;
    const std::filesystem::path path = std::filesystem::absolute(scene, error).lexically_normal();
    return {{path.stem().string(), std::nullopt},
            {path.parent_path().filename().string(), std::nullopt},
            {path.parent_path().parent_path().filename().string(), std::nullopt}};
}

// Numbers the files of frames whose pattern has no placeholder.
std::string numbered(const std::string& pattern) {
    const std::filesystem::path path(pattern);
    return (path.parent_path() / (path.stem().string() + "-{frame:04}" + path.extension().string())).string();
}

}  // namespace

std::optional<Shard> parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    const auto index = whole(text.substr(0, slash)), count = whole(text.substr(slash + 1));
    if (!index || !count || *index >= *count) return std::nullopt;
    return Shard{*index, *count};
}

std::size_t Shots::per_scene() const {
    std::size_t count = 1;
    for (const Axis& axis : axes) count *= axis.values.size();
    return count;
}

Shot Shots::shot(std::size_t index) const {
    Shot shot{index, index / per_scene(), std::vector<std::size_t>(axes.size())};
    std::size_t rest = index % per_scene();
    for (std::size_t axis = axes.size(); axis-- > 0;) {
        shot.at[axis] = rest % axes[axis].values.size();
        rest /= axes[axis].values.size();
    }
    return shot;
}

std::string Shots::label(const Shot& shot) const {
    std::string text = labels[shot.scene];
    for (std::size_t axis = 0; axis < axes.size(); ++axis)
        text += fmt::format("{}{}={}", text.empty() ? "" : " ", axes[axis].name, value(shot, axis).shown());
    return text;
}

std::vector<std::string> distinguishing_paths(const std::vector<std::string>& paths) {
    std::vector<std::vector<std::string>> parts;
    for (const std::string& path : paths) {
        parts.emplace_back();
        const std::filesystem::path whole = std::filesystem::path(path).lexically_normal().replace_extension();
        for (const auto& part : whole)
            if (part != "/") parts.back().push_back(part.string());
    }
    const auto all_share = [&](auto end) {
        return ranges::all_of(parts, [&](const auto& own) { return own.size() > 1 && end(own) == end(parts[0]); });
    };
    while (parts.size() > 1 && all_share([](const auto& own) { return own.back(); }))
        for (auto& own : parts) own.pop_back();
    while (!parts.empty() && all_share([](const auto& own) { return own.front(); }))
        for (auto& own : parts) own.erase(own.begin());
    std::vector<std::string> short_paths;
    for (const auto& own : parts) short_paths.push_back(fmt::format("{}", fmt::join(own, "/")));
    return short_paths;
}

std::optional<Shots> plan_shots(std::vector<std::string> scenes, std::vector<Axis> axes, const std::string& pattern,
                                std::string& error) {
    Shots shots{std::move(scenes), std::move(axes), {}, {}, {}};
    shots.paths = distinguishing_paths(shots.scenes);
    shots.labels = stems_of(shots.scenes);
    if (!distinct(shots.labels)) shots.labels = shots.paths;
    if (shots.scenes.size() == 1) shots.labels.front().clear();
    if (error = check_names(shots.axes); error.empty()) error = check_count(shots);
    if (!error.empty()) return std::nullopt;
    const bool frames =
        ranges::any_of(shots.axes, [](const Axis& axis) { return axis.frames && axis.values.size() > 1; });
    const bool told = pattern.find("{frame") != std::string::npos || pattern.find("{index") != std::string::npos;
    std::vector<std::string> names{"stem", "dir", "parent", "path", "index"};
    for (const Axis& axis : shots.axes) names.push_back(axis.name);
    const auto parsed = Pattern::parse(frames && !told ? numbered(pattern) : pattern, names, error);
    if (!parsed) return std::nullopt;
    const std::size_t count = shots.scenes.size() * shots.per_scene();
    shots.files.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Shot shot = shots.shot(i);
        std::vector<AxisValue> values = names_of_scene(shots.scenes[shot.scene]);
        values.push_back({shots.paths[shot.scene], std::nullopt});
        values.push_back({std::to_string(i), static_cast<double>(i)});
        for (std::size_t axis = 0; axis < shots.axes.size(); ++axis) values.push_back(shots.value(shot, axis));
        auto file = parsed->expand(values, error);
        if (!file) return std::nullopt;
        shots.files.push_back(std::move(*file));
    }
    error = check_distinct(shots);
    return error.empty() ? std::optional(std::move(shots)) : std::nullopt;
}

}  // namespace snell::app
