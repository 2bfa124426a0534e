// The measurement: pictures and errors first, then times in interleaved rounds.
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
    bool drawn = false;  // false: this context can't, and nothing below is known
    Picture picture;
    Error whole, own;  // over the whole picture, and over the pixels that the ladder's own draws cover
    double flip = 0;   // mean over `own`
    std::optional<Degrees> degrees;
    bool saturated = false;                      // so far off that rmse no longer ranks
    bool below_residual = false;                 // nearer to the reference than it is to the truth, times three
    std::vector<double> cpu, wall, gpu;          // milliseconds by round; 0: sat it out
    double milliseconds = 0, low = 0, high = 0;  // median of the chosen clock, and its interval
    Interval ratio{1, 1, 1};                     // to the base rung
    std::size_t rounds = 0;
    Verdict verdict;
    bool cliff = false;
};

enum class Metric { rmse, degrees };

struct SweepResult {
    std::string scene;  // as it was named
    Sweep sweep;
    std::vector<RungResult> rungs;
    std::size_t own_pixels = 0;  // 0: no draw of its own is known, and `own` is the whole picture
    Metric metric = Metric::rmse;
    Control control;
    bool few_rounds = false;         // too few for an interval: no front
    std::optional<double> residual;  // rmse of the reference against the truth, as the steps toward it suggest
    std::string residual_note;       // how it is known, or why not
    ClockKind clock = ClockKind::wall;
    bool interrupted = false;

    // Whether verdicts mean anything.
    bool trusted() const { return !control.noisy && !few_rounds; }
    double error(const RungResult& rung) const;  // what the front is made of
};

struct Progress {
    std::string_view sweep, doing;
    double done = 0;          // 0..1 of this sweep
    double seconds_left = 0;  // of this sweep
};

struct MeasureOptions {
    int rounds = 31;       // at least 3; more while the control is noisy and seconds are left
    double seconds = 30;   // for this sweep; dear rungs sit rounds out to keep it
    bool times = true;     // false: errors only
    double at_least = 20;  // milliseconds of a sample: quicker frames are drawn several times
    std::uint64_t seed = 1;
    std::function<bool()> stop;                   // asked between frames
    std::function<void(const Progress&)> report;  // called between frames
};

SweepResult measure(Bench& bench, const Sweep& sweep, const MeasureOptions& options);

// Of pictures and times as they are: what measure() concludes from them, for tests and for what was stopped.
void conclude(SweepResult& result, std::span<const double> base_again, std::uint64_t seed);

}  // namespace snell::accuracy
