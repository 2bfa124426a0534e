// What a scene was like when it was last open in a window: one small file for each scene, in a folder next to the
// settings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "src/plan/setup.h"

namespace snell {

inline constexpr std::size_t most_kept_scenes = 200;
inline constexpr std::uintmax_t most_kept_bytes = std::uintmax_t{256} << 10;  // of one scene

// The folder next to the settings; "" if there are none.
std::string kept_folder(const std::string& settings);
// The scene's path without links, by which it is kept.
std::string kept_name(const std::string& scene);

// Returns nothing if the scene was not kept, or its file is of something else or too large. Its file then counts as
// used now. Of the view there is also the name of each object that it moves, as what was written of "--view object3".
Remembered read_kept(const std::string& folder, const std::string& scene);
// Replaces what is kept of the scene, and removes the files of those that were not opened or changed for the longest
// time. Returns "" or the error.
std::string write_kept(const std::string& folder, const std::string& scene, const Remembered& kept);

// Files of the program's own, in folders of its own.

// The place with that name, which begins with a slash, in the folder of the environment's variable; without it, in that
// folder at home; "" if there is no home, either.
std::string own_place(const char* variable, const std::string& at_home, const std::string& name);

// Removes all but the newest ones of the files with that extension, such as ".txt".
void remove_oldest(const std::string& folder, std::string_view extension, std::size_t most);

// The file in the folder that belongs to the path, such as "/home/ann/.cache/x/00c0ffee00c0ffee.png": the same in every
// version of the program. `extension` is without the dot.
std::string named_by(const std::string& folder, std::string_view path, std::string_view extension);

}  // namespace snell
