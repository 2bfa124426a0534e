// What a window remembers from run to run: its appearance, the recent scenes, and what each scene was like.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/setup.h"
#include "src/platform/window.h"
#include "src/ui/panels/state.h"

namespace snell {

inline constexpr std::size_t most_recent = 12;

struct Settings {
    ui::Theme theme = ui::Theme::light;
    double zoom = 1, panel_width = 22;  // in multiples of the text height
    bool panel = true;
    bool always_sharp = false;
    bool tools = false;             // whether the panel shows its second tab
    std::vector<std::string> open;  // titles of the open sections
    int width = 0, height = 0;      // of the window, in its coordinates at zoom 1 and 96 dots per inch; 0: unknown
    std::vector<std::string> recent;
    std::string editor;  // as editor_of_environment(); empty: that

    bool operator==(const Settings&) const = default;
};

// Returns $XDG_STATE_HOME/snell/window.json, with ~/.local/state as the default of the variable; "" if there is no home
// folder.
std::string settings_file();

// Values that are missing, damaged or out of range get their defaults.
Settings read_settings(const std::string& file);
// Writes the settings. Recent scenes that other windows added in the meantime are kept. Returns "" or the error.
std::string write_settings(const std::string& file, const Settings& settings);

// The absolute path of a scene, as recent scenes are listed.
std::string whole_path(const std::string& scene);
// Moves the scene to the front of the recent ones, which are absolute paths, each listed once. A path that is not UTF-8
// is left out, because JSON could not bring it back.
void remember(std::vector<std::string>& recent, const std::string& scene);

// Copies settings to the panels' memory, and back.
void restore(const Settings& settings, const std::string& scene, ui::Memory& memory);
void gather(const ui::Memory& memory, Settings& settings);
// Copies the appearance of the window from one scene's memory to the next.
void carry_looks(const ui::Memory& before, ui::Memory& memory);

// What a scene was like when it was last open in a window: one small file for each scene, in a folder next to the
// settings.

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
