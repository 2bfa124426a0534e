// Measures a sweep: first pictures and errors, then times in interleaved rounds.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/bench.h"
#include "src/accuracy/front.h"
#include "src/accuracy/metrics.h"
#include "src/accuracy/sweep.h"

namespace snell::accuracy {

struct RungResult {
    std::string name;
    std::vector<std::size_t> steps;
    bool drawn = false;  // if false, this context cannot draw it, and the members below have no values
    Picture picture;
    Error whole, own;  // over the whole picture, and over the pixels that the ladder's own draws cover
    double flip = 0;   // mean over the pixels of `own`
    std::optional<Degrees> degrees;
    bool saturated = false;              // the error is so large that RMSE no longer ranks
    bool below_residual = false;         // the error is below three times the estimated residual of the reference
    std::vector<double> cpu, wall, gpu;  // in milliseconds by round; 0 if it did not take part
    double milliseconds = 0, low = 0, high = 0;  // median of the chosen clock, and its interval
    Interval ratio{1, 1, 1};                     // relative to the base rung
    std::size_t rounds = 0;
    Verdict verdict;
    bool cliff = false;
};

enum class Metric { rmse, degrees };

struct SweepResult {
    std::string scene;  // as the user gave it
    Sweep sweep;
    std::vector<RungResult> rungs;
    std::size_t own_pixels = 0;  // 0 if no draw of its own is known; `own` is then over the whole picture
    Metric metric = Metric::rmse;
    Control control;
    bool few_rounds = false;  // too few for an interval, so there is no front
    // Estimated RMSE of the reference compared with the exact picture, extrapolated from the steps towards it.
    std::optional<double> residual;
    std::string residual_note;  // how the residual was estimated, or why it could not be
    ClockKind clock = ClockKind::wall;
    bool interrupted = false;

    // True if the verdicts are meaningful.
    bool trusted() const { return !control.noisy && !few_rounds; }
    double error(const RungResult& rung) const;  // the error by `metric`, which the front uses
};

struct Progress {
    std::string_view sweep, doing;
    double done = 0;          // 0..1 of this sweep
    double seconds_left = 0;  // for this sweep
};

struct MeasureOptions {
    int rounds = 31;       // at least 3; increased while the control is noisy and time is left
    double seconds = 30;   // time for this sweep; expensive rungs skip rounds to stay within it
    bool times = true;     // if false, only errors are measured
    double at_least = 20;  // minimum milliseconds of a sample: faster frames are drawn several times
    std::uint64_t seed = 1;
    std::function<bool()> stop;                   // called between frames; returns true to stop
    std::function<void(const Progress&)> report;  // called between frames
};

// Measures all rungs of the sweep. The bench's context must be current.
SweepResult measure(Bench& bench, const Sweep& sweep, const MeasureOptions& options);

// Computes the conclusions from the pictures and times in `result`. measure() calls it; it is public for tests and for
// interrupted measurements.
void conclude(SweepResult& result, std::span<const double> base_again, std::uint64_t seed);

}  // namespace snell::accuracy
