// Recommends combinations of rungs by measurement: the cheapest that is exact enough, or the most exact that is fast
// enough.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// Limits that a combination should meet. Without any limit, the cheapest is wanted.
struct Wish {
    std::optional<double> milliseconds = {};  // by the clock that choose_clock() picked
    std::optional<double> error = {};         // RMSE of the light, over the pixels that the ladders' draws cover
    // The same, but compared with the last rungs at the scene's knobs: what the choice of rungs alone does.
    std::optional<double> alone = {};
};

// Returns the rung of a sweep that fulfils the wish best, among those that were drawn and timed. An error counts with
// the residual of the reference added (if that is not known, none is small enough), a time with the upper end of its
// interval. If several fulfil it: with a limit of error alone, or without limits, the cheapest, and of equally cheap
// ones the most exact; with a limit of time, the most exact, and of equally exact ones the cheapest. If none does, the
// nearest; with both limits, the cheapest of those that are exact enough. Of equals, the one whose rungs are nearer to
// the last ones. Nullopt if none was timed with a finite error, or nothing can be said.
std::optional<std::size_t> choose(const SweepResult& sweep, const Wish& wish);
// The same, but a wish for an error alone never gets a rung that is not surely cheaper than the current one, if that
// fulfils it.
std::optional<std::size_t> choose_surely(const SweepResult& sweep, const Wish& wish);
// True if the rung of the sweep meets the wish's limits.
bool fulfils(const SweepResult& sweep, const RungResult& rung, const Wish& wish);

struct Advice {
    Wish wish;
    bool known = false;       // if false, nothing can be said, and the members below have no values
    bool met = false;         // if false, this is the nearest that was found
    bool everything = false;  // every combination was measured; if false, only those that differ in one ladder
    bool settled = false;     // no measured combination is better; false if the time ran out
    std::size_t sweep = 0;    // the index into Counsel::sweeps of the sweep that contains it
    std::size_t rung = 0;     // the index of the rung within that sweep
};

struct Counsel {
    std::vector<Advice> advice;       // in the order of the wishes
    std::vector<SweepResult> sweeps;  // everything that was measured; each sweep has its own control
};

// Measures all combinations if they are few. Otherwise starts at the reference and moves to the best combination that
// differs in one ladder, until none is better. The scene must have ladders. `options.seconds` limits the whole search.
Counsel advise(Bench& bench, const Rungs& now, std::span<const Wish> wishes, const MeasureOptions& options);

// The chosen rung of each ladder as "A=x".
std::vector<std::string> choices(const Scene& scene, const Rungs& rungs);

}  // namespace snell::accuracy
