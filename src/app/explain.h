// `snell explain`: what a scene pays for, as text and JSON. Values in, text out.
#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/source.h"
#include "src/gl/caps.h"
#include "src/runtime/explain.h"
#include "src/runtime/runtime.h"

namespace snell::app {

struct ExplainReport {
    std::string scene, clock;  // clock: "CPU time of the process", …; empty: frames were not timed
    gl::Caps caps;
    int width = 0, height = 0, rounds = 0;
    FrameCost frame;
    double spread = 0;  // median absolute deviation of the frame's chosen clock, milliseconds
    Explanation explanation;
    Counters load, per_frame;  // of loading, and of one frame more
    Diagnostics lints;
};

std::string explain_text(const ExplainReport& report, const Sources& sources);
// "schema" 1; its keys are those of docs/architecture.md.
nlohmann::ordered_json explain_json(const ExplainReport& report, const Sources& sources);

// The time of every pass and of the draws with every program, by difference: without these draws, in interleaved
// rounds of which there are `rounds`, or fewer when they would take more than 20 seconds. Cube passes that are kept
// have none. `before` is called before frames are drawn.
void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface, int rounds,
                 const std::function<void()>& before);

}  // namespace snell::app
