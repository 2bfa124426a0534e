// Times and formats what a scene pays for, for `snell explain`.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/runtime/explain.h"
#include "src/runtime/runtime.h"

namespace snell::app {

// What can be left out of the scene's texts without changing a pixel at any of some places
// (src/accuracy/found/search.h), of which some were not searched on.
struct WithoutEffect {
    struct Row {
        std::string rung;                // its number, for `snell accuracy --apply`
        std::string place;               // file:line:column
        std::string what;                // the text that is left out
        std::optional<FrameCost> frame;  // what it costs in each frame; nullopt: not timed
        std::int64_t gpu_bytes = 0, bytes_decoded = 0;
        std::optional<double> load_ms = {};  // of loading; 0: less than can be measured; nullopt: not measured
    };
    std::string cannot_say;  // why nothing was left out; empty if nothing is wrong with the scene
    std::vector<Row> rows;
    std::size_t tried = 0, places = 0, held_out = 0;
    bool late = false;  // the time was up before all were tried
};

struct ExplainReport {
    std::string scene, clock;  // such as "CPU time of the process"; empty if frames were not timed
    gl::Caps caps;
    int width = 0, height = 0;
    int rounds = 0, asked = 0;  // that were drawn, and that were asked for
    FrameCost frame;
    double spread = 0;  // median absolute deviation of the frame's time by the chosen clock, in milliseconds
    Explanation explanation;
    std::optional<FrameCost> saved;  // by programs for these values against those for any; none: not measured
    Counters load, per_frame;        // for loading, and for one further frame
    Diagnostics lints;
    std::optional<WithoutEffect> without_effect;  // nullopt: not asked for
};

std::string explain_text(const ExplainReport& report, const Sources& sources);
// Has "schema" 1 and the keys that docs/architecture.md lists.
std::string explain_json(const ExplainReport& report, const Sources& sources);

// The time by the clock that is trusted, in milliseconds.
double shown(const FrameCost& cost, bool software);

// How long frames are timed.
struct Timing {
    int rounds = 31;
    double milliseconds = 20e3;                           // for all rounds; expensive frames get fewer rounds
    double frame = 0;                                     // milliseconds that a frame takes, if known
    std::function<void(int round, double share)> report;  // called before each frame; share: 0 to 1
};

// The same scene with programs that take more values. `saved` gets what its frames take more.
struct Comparison {
    std::unique_ptr<Document> document;
    std::optional<FrameCost>* saved;
};

// Times every pass, and the draws of every program, by difference: whole frames and frames without these draws are
// timed in interleaved rounds. Cube passes that are not drawn again have no time, nor have parts for which the time was
// up. So are frames of `comparisons`, which were drawn before, too. `clock` stays empty if there is no time for a
// frame. Precondition: the frame was drawn before.
void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing, std::span<const Comparison> comparisons = {});

}  // namespace snell::app
