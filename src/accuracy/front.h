// Decides which rungs are worth their time, given the uncertainty of the times.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "src/accuracy/costs.h"

namespace snell::accuracy {

inline constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
// A rung: its error compared with the reference (in any unit, 0 is none, infinite the worst), and its time in each
// round, in milliseconds. A time of 0 marks a round that it did not take part in. All rungs of a front must be from the
// same rounds.
struct Point {
    double error = 0;
    std::vector<double> times;
};

enum class Standing {
    front,       // none of the following
    dominated,   // `by` is surely cheaper, and not worse
    saves_none,  // `by` is more exact at equal cost, so this rung saves nothing
    unsure,      // `by` is more exact, and this rung is not surely cheaper
    unknown,     // error or time is not a number; or the error is infinite, and no other rung is as cheap
};

struct Verdict {
    Standing standing = Standing::front;
    std::size_t by = nobody;
    bool operator==(const Verdict&) const = default;
};

Costs costs_of(std::span<const Point> points, double noise = 0);

// Errors within a thousandth are equal, and an error that is smaller by less than a hundredth is not better. `costs`
// are those of the points.
std::vector<Verdict> pareto_front(std::span<const Point> points, const Costs& costs);

// For each rung of a ladder, whether it is surely more expensive than both neighbours. Always false for the first and
// the last.
std::vector<bool> cliffs(std::size_t rungs, const Costs& costs);

}  // namespace snell::accuracy
