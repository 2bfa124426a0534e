// Rungs of ladders, samples a pixel and found rungs together: each combination is drawn and timed, because errors do
// not add up.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/advice.h"
#include "src/accuracy/found/search.h"

namespace snell::accuracy {

struct Mix {
    Rungs rungs;                       // of the ladders
    int samples = 1;                   // a pixel, taken by the driver
    std::vector<std::size_t> changes;  // indices into FoundResult::changes
    bool operator==(const Mix&) const = default;
};

struct MixAdvice {
    // Errors are the largest of all places: at the scene's own, from the reference, over the pixels in which the scene
    // draws; elsewhere, from the last rungs with as many samples. The scene as it stands is the current rung; the
    // reference is none of them.
    SweepResult sweep;
    std::vector<Mix> mixes;  // of the sweep's rungs
    std::optional<std::size_t> best;
    bool met = false;
    bool whole = false;    // all that differs in one thing was drawn, and timed in enough rounds
    bool settled = false;  // nothing that differs in one thing is better
    std::size_t places = 0;
};

struct MixOptions {
    std::vector<Rungs> rungs;  // that are tried, besides the scene's and the last ones
    MeasureOptions measuring;  // with references
};

// Starts where the wish is fulfilled best alone, and moves to what is best of all that differs in the ladders, in the
// samples or in the found rung, until nothing is better. `bench` draws the reference.
MixAdvice advise_together(const Original& original, const FoundResult& found, Bench& bench, const gl::Caps& caps,
                          const BenchSettings& settings, const Wish& wish, const MixOptions& options);

// The rung that fulfils the wish best, as choose() says. But a wish for an error alone never gets one that is not
// surely cheaper than the current rung, if that fulfils it: its time is below those that the current rung has, timed
// twice.
std::optional<std::size_t> choose_surely(const SweepResult& sweep, const Wish& wish);

}  // namespace snell::accuracy
