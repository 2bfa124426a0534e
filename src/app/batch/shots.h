// The list of pictures that a command draws: what varies, in which order, and under which file names. No GL.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

// For one command, all shards together.
constexpr std::size_t max_pictures = 1'000'000;

struct AxisValue {
    std::string written;           // as for `--set` and `--ladder`
    std::optional<double> number;  // set if the value is a single number

    // The text for file names and labels: the shortest text that reads back to the same number, without brackets.
    std::string shown() const;
};

// A quantity that varies, and its values.
struct Axis {
    std::string name;
    std::vector<AxisValue> values;
    bool frames = false;  // the values are frame numbers
};

// Parses an axis such as "uEta=1:2.5:16" (16 values, including both ends exactly), "uMix=0,.5,1",
// "uColor=[1,0,0],[0,1,0]" or "FRESNEL=f0,exact". Returns nullopt and sets `error` if values are not finite, missing or
// too many.
std::optional<Axis> parse_axis(std::string_view text, std::string& error);

// The axis with the values 0, 1 … count - 1.
Axis frames_axis(std::size_t count);

// A part of the pictures. Picture k belongs to shard (k + k / count) mod count. So shards differ by at most one
// picture, and each one gets different values of the axis that varies fastest.
struct Shard {
    std::size_t index = 0, count = 1;
    bool has(std::size_t picture) const { return (picture + picture / count) % count == index; }
};
// Parses "0/8" to "7/8".
std::optional<Shard> parse_shard(std::string_view text);

struct Shot {
    std::size_t index = 0;        // among all pictures of the command
    std::size_t scene = 0;        // index into Shots::scenes
    std::vector<std::size_t> at;  // the index of the value on each of Shots::axes
};

// All pictures: the scenes times the product of all axes, of which the last varies fastest.
struct Shots {
    std::vector<std::string> scenes;
    std::vector<Axis> axes;
    std::vector<std::string> files;   // by the index of the picture
    std::vector<std::string> paths;   // by scene: see distinguishing_paths
    std::vector<std::string> labels;  // by scene: its stem, or its path if stems are equal; "" for a single scene

    // The number of pictures of each scene.
    std::size_t per_scene() const;
    Shot shot(std::size_t index) const;
    const AxisValue& value(const Shot& shot, std::size_t axis) const { return axes[axis].values[shot.at[axis]]; }
    // Formats as "uEta=1.5 uMix=0", preceded by the scene's stem if there are several scenes, or by what distinguishes
    // their paths if stems do not.
    std::string label(const Shot& shot) const;
};

// Of each path without its extension, what is left without the folders that all begin with and the names that all end
// with, but at least one name: "ann" and "bob" for class/ann/project.glib and class/bob/project.glib.
std::vector<std::string> distinguishing_paths(const std::vector<std::string>& paths);

// Plans all pictures. `pattern` gives the file names: {stem} of the scene, {dir}, the name of its folder, {parent},
// that of the folder above, {path}, which distinguishes it from the other scenes, {index}, {NAME} of an axis, each
// optionally with a format such as {uEta:.2f}; {{ is a brace. If frames would get the same name, "-{frame:04}" is added
// before the extension. Returns nullopt and sets `error` if a name is unknown, a format does not suit, or two pictures
// would have the same file name.
std::optional<Shots> plan_shots(std::vector<std::string> scenes, std::vector<Axis> axes, const std::string& pattern,
                                std::string& error);

// The folder before the first placeholder; it must exist.
std::string fixed_folder(const std::string& pattern);

// File names with placeholders.

class Pattern {
public:
    // Parses a pattern such as "out/{uEta:.2f}.png"; `names` are the valid placeholders. Returns nullopt and sets
    // `error` for any other name.
    static std::optional<Pattern> parse(std::string_view text, const std::vector<std::string>& names,
                                        std::string& error);
    // Replaces the placeholders; `values` is in the order of the names given to parse. Returns nullopt and sets `error`
    // if a format does not suit its value.
    std::optional<std::string> expand(const std::vector<AxisValue>& values, std::string& error) const;

private:
    struct Piece {
        std::string literal;      // text before the value
        std::size_t name = 0;     // index of the value's name; past the end of the names: no value
        std::string format;       // such as "{:.2f}"; "": the default format
        std::string placeholder;  // as written in the pattern
    };
    std::vector<Piece> pieces_;
};

}  // namespace snell::app
