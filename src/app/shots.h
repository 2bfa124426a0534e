// Which pictures a command draws: what varies, in which order, and under which names. No GL here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

// Of one command, all its shards together.
constexpr std::size_t max_pictures = 1'000'000;

struct AxisValue {
    std::string written;           // as `--set` and `--ladder` take it
    std::optional<double> number;  // where it is one

    // Names of files and labels show it: numbers as short as reads back the same, no brackets.
    std::string shown() const;
};

// What varies.
struct Axis {
    std::string name;
    std::vector<AxisValue> values;
    bool frames = false;  // the values are numbers of frames
};

// "uEta=1:2.5:16" (16 values, both ends exactly), "uMix=0,.5,1", "uColor=[1,0,0],[0,1,0]", "FRESNEL=f0,exact".
// Nothing, with the error, for what is not finite, empty or too much.
std::optional<Axis> parse_axis(std::string_view text, std::string& error);

// 0, 1 … count - 1.
Axis frames_axis(std::size_t count);

// Picture k belongs to shard (k + k / count) mod count: shards differ by one picture at most, and no value of the
// axis that varies fastest stays with one shard.
struct Shard {
    std::size_t index = 0, count = 1;
    bool has(std::size_t picture) const { return (picture + picture / count) % count == index; }
};
// "0/8" to "7/8".
std::optional<Shard> parse_shard(std::string_view text);

struct Shot {
    std::size_t index = 0;        // among all of the command
    std::size_t scene = 0;        // Shots::scenes
    std::vector<std::size_t> at;  // by Shots::axes: the place of the value
};

// Scenes times the product of all axes, the last of which varies fastest.
struct Shots {
    std::vector<std::string> scenes;
    std::vector<Axis> axes;
    std::vector<std::string> files;  // by index

    std::size_t per_scene() const;
    Shot shot(std::size_t index) const;
    const AxisValue& value(const Shot& shot, std::size_t axis) const { return axes[axis].values[shot.at[axis]]; }
    // "uEta=1.5 uMix=0", after the scene's stem where there are several.
    std::string label(const Shot& shot) const;
};

// `pattern` names the files: {stem} of the scene, {index}, {NAME} of an axis, each with a format such as {uEta:.2f} if
// wanted; {{ is a brace. A pattern that tells frames apart by nothing gets "-{frame:04}" before its extension. Nothing,
// with the error, where a name is unknown, a format does not suit, or two pictures would be one file.
std::optional<Shots> plan_shots(std::vector<std::string> scenes, std::vector<Axis> axes, const std::string& pattern,
                                std::string& error);

// The folder before the first placeholder, which must be there.
std::string fixed_folder(const std::string& pattern);

}  // namespace snell::app
