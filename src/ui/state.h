// What the panels show, what they change, and what they remember from frame to frame.
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "parser/source.h"
#include "src/plan/controls.h"
#include "src/plan/view.h"
#include "src/runtime/explain.h"
#include "src/ui/accuracy.h"
#include "src/ui/layout.h"
#include "src/ui/widgets.h"

namespace snell::ui {

// A diagnostic as it is printed.
struct Problem {
    Severity severity = Severity::error;
    std::string text;
};

struct Facts {
    std::string_view file;                 // the scene's name, without its folder
    const Scene* scene = nullptr;          // none: it could not be read
    std::span<const char> linked;          // by Scene::programs: not 0 where it can draw
    std::span<const Problem> problems;     // of the files as they are now
    bool stale = false;                    // the picture is that of an earlier, working state of the files
    std::uint64_t revision = 0;            // counts readings of the files
    bool animated = false, mouse = false;  // the picture depends on time, on where the mouse is
    double time = 0;                       // seconds since the scene began
    double frame_ms = 0;                   // to draw the last picture
    int samples = 1;
    std::string_view renderer;
    const AccuracyFacts* accuracy = nullptr;   // while its panel is open
    const Explanation* explanation = nullptr;  // while Memory::costs
    const Sources* sources = nullptr;          // that the spans of it are of
};

struct Memory {
    bool panel = true;
    float panel_width = 0;  // window coordinates; 0: not chosen yet
    bool warnings_open = false;
    bool problems_hidden = false;
    std::uint64_t revision = 0;       // that `problems_hidden` speaks of
    std::set<std::string> dismissed;  // messages
    SliderMemory slider;
    AccuracyMemory accuracy;
    bool costs = false;  // that panel is open
    Rect scene;          // where the scene is, of this frame
};

// What a user asked for in this frame that is not a change of Controls or View.
struct Requests {
    bool reload = false;
    bool measure = false;  // all rungs of the plotted ladder; while they are measured: no longer
};

}  // namespace snell::ui
