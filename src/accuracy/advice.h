// The cheapest combination of rungs that is exact enough, or the most exact that is quick enough: found by measurement.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// What is asked for. Of neither limit: the cheapest there is.
struct Wish {
    std::optional<double> milliseconds;  // of the clock that is believed
    std::optional<double> error;         // RMSE in linear light over the pixels that the ladders' draws cover
};

// Of the rungs of a sweep that were drawn and timed, the one that fulfils the wish best. Where several do: with a limit
// of error alone, or none, the cheapest, and of those that cost the same the most exact; with a limit of time the most
// exact, and of those as exact the cheapest. Where none does: the nearest; with both limits, of those that are exact
// enough the cheapest. Nothing: none was timed.
std::optional<std::size_t> choose(const SweepResult& sweep, const Wish& wish);
bool fulfils(const RungResult& rung, const Wish& wish);

struct Advice {
    Wish wish;
    bool met = false;         // false: the nearest is given
    bool everything = false;  // every combination was measured; else those that differ in one ladder
    bool settled = false;     // none of them fulfils the wish better; false: time was up
    std::size_t sweep = 0;    // of Counsel::sweeps, where it stands …
    std::size_t rung = 0;     // … as this one
};

struct Counsel {
    std::vector<Advice> advice;       // by wish
    std::vector<SweepResult> sweeps;  // what was measured, each with its own control
};

// All combinations, where they are few; else from the reference to the best of all that differ in one ladder, until
// none is better. Precondition: the scene has ladders. `seconds` is for all of it.
Counsel advise(Bench& bench, const Rungs& now, std::span<const Wish> wishes, const MeasureOptions& options);

// "A=x", of each ladder.
std::vector<std::string> choices(const Scene& scene, const Rungs& rungs);

}  // namespace snell::accuracy
