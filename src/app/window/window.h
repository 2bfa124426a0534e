// The window: it shows a scene with its sliders, and draws only when something changed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/plan/files.h"

namespace snell {

struct WindowOptions {
    std::string scene;  // a folder or "": the window begins with the file browser, in that folder or the current one
    std::optional<std::pair<int, int>> size;
    std::string state_file;  // for tests: counters, values and layout are written to this file after every frame
    double exit_after = 0;   // in seconds; 0: never
    std::string quality;     // the preset that the scene begins with; empty: its own rungs
    std::vector<std::string> ladders;  // NAME=rung; applied after the preset
    Access access;
    double timeout = 60;     // in seconds for one frame; 0: no timeout
    bool specialise = true;  // compile programs for the values as they are, while nothing is touched
    std::string after;       // passed by Restart to a window that was restarted
    std::string lose_file;   // for tests: when this file exists, the context counts as lost
};

// Returns the exit status.
int run_window(const WindowOptions& options);

}  // namespace snell
