// The window: a scene, its sliders, and the loop that draws only when something changed.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/plan/files.h"

namespace snell {

struct WindowOptions {
    std::string scene;
    std::optional<std::pair<int, int>> size;
    std::string state_file;            // for tests: counters, values and layout are written there after every frame
    double exit_after = 0;             // seconds; 0: never
    std::string quality;               // the preset that the scene begins with; empty: its own rungs
    std::vector<std::string> ladders;  // NAME=rung, on top of that
    Access access;
    double timeout = 60;    // seconds of one frame; 0: no end
    std::string after;      // of a window that was started again: Restart
    std::string lose_file;  // for tests: while it is there, the context is lost
};

// Returns the exit status.
int run_window(const WindowOptions& options);

}  // namespace snell
