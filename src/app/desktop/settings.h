// The settings that a window remembers from run to run: its appearance and the recent scenes.
#pragma once

#include <string>
#include <vector>

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

}  // namespace snell
