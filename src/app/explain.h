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
    int width = 0, height = 0;
    int rounds = 0, asked = 0;  // that were drawn, and that were asked for
    FrameCost frame;
    double spread = 0;  // median absolute deviation of the frame's chosen clock, milliseconds
    Explanation explanation;
    Counters load, per_frame;  // of loading, and of one frame more
    Diagnostics lints;
};

std::string explain_text(const ExplainReport& report, const Sources& sources);
// "schema" 1; its keys are those of docs/architecture.md.
nlohmann::ordered_json explain_json(const ExplainReport& report, const Sources& sources);

// How long frames are timed.
struct Timing {
    int rounds = 31;
    double milliseconds = 20e3;                           // for all of them: fewer rounds where frames are expensive
    double frame = 0;                                     // milliseconds that a frame takes, as far as that is known
    std::function<void(int round, double share)> report;  // called before each frame; share: 0 to 1
};

// The time of every pass and of the draws with every program, by difference: without these draws, in interleaved
// rounds. Cube passes that are kept have none, and no part has one that time was up for. `clock` stays empty where
// there is no time for a frame. Precondition: the frame was drawn before.
void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing);

}  // namespace snell::app
