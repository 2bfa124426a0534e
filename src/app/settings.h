// What a window remembers from run to run: its looks, and the scenes that were open.
#pragma once

#include <string>
#include <vector>

#include "src/platform/window.h"
#include "src/ui/state.h"

namespace snell {

inline constexpr std::size_t most_recent = 12;

struct Settings {
    bool dark = false;
    double zoom = 1, panel_width = 22;  // in heights of the letters
    bool panel = true;
    std::vector<std::string> open;  // sections
    int width = 0, height = 0;      // of the window, in its coordinates at zoom 1 and 96 dots per inch; 0: not known
    std::vector<std::string> recent;

    bool operator==(const Settings&) const = default;
};

// $XDG_STATE_HOME/snell/window.json, ~/.local/state where that is not set; "" where there is no home.
std::string settings_file();

// What is missing, damaged or out of range is as in a first run.
Settings read_settings(const std::string& file);
// Scenes that other windows opened meanwhile stay in the list. "" or why not.
std::string write_settings(const std::string& file, const Settings& settings);

// The scene is the last one now. Absolute paths, once each.
void remember(std::vector<std::string>& recent, const std::string& scene);

// To and from what the panels hold.
void restore(const Settings& settings, ui::Memory& memory);
void gather(const ui::Memory& memory, Settings& settings);
// From one scene to the next.
void carry_looks(const ui::Memory& before, ui::Memory& memory);

}  // namespace snell
