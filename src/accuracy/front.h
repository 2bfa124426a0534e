// Decides which rungs are worth their time, given the uncertainty of the times.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "src/accuracy/statistics.h"

namespace snell::accuracy {

inline constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

// A rung: its error compared with the reference (in any unit, 0 is exact), and its time in each round, in milliseconds.
// A time of 0 marks a round that it did not take part in. All rungs of a front must be from the same rounds.
struct Point {
    double error = 0;
    std::vector<double> times;
};

enum class Standing {
    front,       // none of the following
    dominated,   // `by` is surely cheaper, and not worse
    saves_none,  // `by` is more exact at equal cost, so this rung saves nothing
    unknown,     // error or time is not a number
};

struct Verdict {
    Standing standing = Standing::front;
    std::size_t by = nobody;
    bool operator==(const Verdict&) const = default;
};

// Surely cheaper: the ratio's whole interval is below 1. Equal cost: the interval contains 1.
bool surely_cheaper(const Interval& ratio);
bool equal_cost(const Interval& ratio);

// Compares all pairs. Errors within a thousandth are equal, and an error that is smaller by less than a hundredth is
// not better. A cost that is higher by less than 3 %, by the median of the ratios, counts as equal.
std::vector<Verdict> pareto_front(std::span<const Point> points, std::uint64_t seed = 1);
// True if another run could give another front: a rung that no other surely beats has an interval that contains this
// limit of 3 %.
bool undecided(std::span<const Point> points, std::uint64_t seed = 1);

// The control measurement: the same rung timed twice under two names.
struct Control {
    Interval ratio{1, 1, 1};
    bool noisy = false;  // the interval does not contain 1, or is wider than 5 %
};
// Compares the times of a rung with those of its second timing, `again`, in the same rounds.
Control control(std::span<const double> first, std::span<const double> again, std::uint64_t seed = 1);

// For each rung of a ladder, whether it is surely more expensive than both neighbours. Always false for the first and
// the last.
std::vector<bool> cliffs(std::span<const Point> ladder, std::uint64_t seed = 1);

}  // namespace snell::accuracy
