// Sweeps, and their measurement: first pictures and errors, then times in interleaved rounds.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/accuracy/bench.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/metrics.h"

namespace snell::accuracy {

// Sweeps: lists of variants to compare. They are the rungs of a ladder, the settings of a knob, or all combinations of
// a few ladders; or rungs that were found (src/accuracy/found/search.h).

enum class SweepKind { ladder, knob, lattice, found };

// The rungs of those ladders that a sweep does not vary.
enum class From { reference, scene };

struct SweepRung {
    std::string name;  // for a lattice, the rungs' names separated by blanks
    Variant variant;
    std::vector<std::size_t> steps;  // for a lattice, the rung of each of its ladders
    // For a ladder, with the others at the other place: where the scene stands, or at the reference. Empty if both
    // places are the same.
    Rungs elsewhere;
};

struct Sweep {
    SweepKind kind = SweepKind::ladder;
    std::string name;                // for a lattice, the ladders' names
    std::vector<SweepRung> rungs;    // cheapest first, in the scene's order
    std::size_t reference = 0;       // index of the rung that errors are measured against
    std::size_t current = 0;         // index of the scene's own rung, the base of all ratios
    std::vector<std::size_t> moved;  // the ladders that vary, as indices into Scene::ladders
    bool numeric = false;            // the rungs' names are counts
    std::string_view elsewhere;      // the other place of SweepRung::elsewhere, as reports name it
};

inline constexpr std::array<std::string_view, 5> knob_names{"samples", "tessellation", "filter", "cube-size",
                                                            "cube-precision"};

// The last rung of every ladder.
Rungs last_rungs(const Scene& scene);

// How many combinations the rungs of these ladders have; at most 2^20 are counted.
std::size_t count_combinations(const Scene& scene, const std::vector<std::size_t>& ladders);
// These, with the other ladders at their last rungs. The last of the ladders changes first.
std::vector<Rungs> all_combinations(const Scene& scene, const std::vector<std::size_t>& ladders);
// A sweep over such combinations, against the reference, with ratios to `base`; both are added if they are missing.
Sweep combination_sweep(const Scene& scene, const std::vector<std::size_t>& ladders, std::vector<Rungs> all,
                        const Rungs& base);

// Returns a sweep for each named ladder; without names, for all ladders. Reports an error for an unknown name.
std::vector<Sweep> ladder_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                                 Diagnostics& diagnostics);
// Returns a sweep over all combinations of two or three ladders; without names, of the scene's first three.
std::vector<Sweep> lattice_sweep(const Scene& scene, const Rungs& now, const std::vector<std::string>& names,
                                 Diagnostics& diagnostics);
// Returns a sweep for each named knob that affects the scene. On a software renderer, cube maps have no anisotropic
// filter, and none is offered for scenes with cube maps.
std::vector<Sweep> knob_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                               bool software, Diagnostics& diagnostics);

struct RungResult {
    std::string name;  // for people
    std::vector<std::size_t> steps;
    bool drawn = false;  // if false, it was not drawn, and the members below have no values
    Picture picture;
    Error whole, own;  // over the whole picture, and over the pixels that the ladder's own draws cover
    double flip = 0;   // mean over the pixels of `own`
    Figures alone;     // of the light: compared with the last rung at the scene's knobs, over the pixels of `own`
    std::optional<Figures> elsewhere;  // the same with the other ladders at the other place (SweepRung::elsewhere)
    std::optional<Degrees> degrees;
    bool saturated = false;                      // the error is so large that RMSE no longer ranks
    bool below_residual = false;                 // the error is not larger than the residual of the reference
    std::vector<double> cpu, wall, gpu;          // in milliseconds by round; 0 if it did not take part
    double milliseconds = 0, low = 0, high = 0;  // median of the chosen clock, and its interval
    Interval ratio{1, 1, 1};                     // relative to the base rung
    std::size_t rounds = 0;
    Verdict verdict;
    bool cliff = false;

    const std::vector<double>& times(ClockKind clock) const {
        return clock == ClockKind::cpu ? cpu : clock == ClockKind::gpu ? gpu : wall;
    }
    // True if it changes next to nothing at one place and visibly at the other: a rung of another ladder hides it.
    bool hidden() const;
};

enum class Metric { rmse, degrees };

struct SweepResult {
    std::string scene;  // as the user gave it
    Sweep sweep;
    std::vector<RungResult> rungs;
    std::size_t own_pixels = 0;  // 0 if no draw of its own is known; `own` is then over the whole picture
    std::string cannot_say;      // why the errors mean nothing; empty if they do
    bool broken = false;         // cannot_say tells of a defect of the scene
    Metric metric = Metric::rmse;
    Control control;
    Costs costs;              // of the rungs
    bool few_rounds = false;  // too few to be sure of anything, so there is no front
    // RMSE of the light, over the pixels of `own`, by which the reference may be wrong.
    std::optional<double> residual;
    std::optional<double> whole_residual;  // the same over the whole picture
    Picture reference;                     // that errors are measured against; empty if it was not drawn
    Knobs finest;                          // of the reference
    std::string reference_note;            // how it was drawn, and how good it is
    ClockKind clock = ClockKind::wall;
    bool interrupted = false;
    bool late = false;  // the time was up before every rung was drawn

    // True if the verdicts are meaningful.
    bool trusted() const { return cannot_say.empty() && !few_rounds; }
    // Whether any of the rungs was timed.
    bool timed() const;
    bool on_front(const RungResult& rung) const {
        return trusted() && rung.rounds > 0 && rung.verdict.standing == Standing::front;
    }
    // The error by `metric`, which the front uses: an RMSE is at least the residual, so nothing ranks below it.
    double error(const RungResult& rung) const;
    // What errors are from: the reference, or, of found rungs, the scene as it is. May be empty.
    const Picture& compared_with() const { return reference.rgba.empty() ? rungs[sweep.reference].picture : reference; }
};

struct Progress {
    std::string_view sweep, doing;
    double done = 0;          // 0..1 of this sweep
    double seconds_left = 0;  // for this sweep
};

struct MeasureOptions {
    int rounds = 31;      // at most; fewer if they do not fit into the time, which is decided before the first one
    double seconds = 30;  // time for this sweep; expensive rungs skip rounds, or are not drawn, to stay within it
    double spare = 0;     // more of it, for the last rung and the current one: without them nothing is known
    References* references = nullptr;  // null: the sweep draws its own, in a quarter of its time
    bool times = true;                 // if false, only errors are measured
    double at_least = 20;              // minimum milliseconds of a sample: faster frames are drawn several times
    std::uint64_t seed = 1;
    Stop stop;
    std::function<void(const Progress&)> report;  // called between frames
};

// Measures all rungs of the sweep. The bench's context must be current.
SweepResult measure(Bench& bench, const Sweep& sweep, const MeasureOptions& options);

// Takes the times of each round.
void take_times(RungResult& rung, std::span<const Times> rounds);

// Computes the conclusions from the errors and times in `result`. measure() calls it; it is public for tests and for
// interrupted measurements.
void conclude(SweepResult& result, std::span<const double> base_again);

}  // namespace snell::accuracy
