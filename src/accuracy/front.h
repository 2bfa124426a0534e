// Decides which rungs are worth their time, given the uncertainty of the times.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "src/accuracy/statistics.h"

namespace snell::accuracy {

inline constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();
// The probability that chance alone makes any of the claims of one front, all pairs together.
inline constexpr double family_level = .05;

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
    unknown,     // error or time is not a number; or the error is infinite, and no other rung is as cheap
};

struct Verdict {
    Standing standing = Standing::front;
    std::size_t by = nobody;
    bool operator==(const Verdict&) const = default;
};

// The ratio's interval contains 1.
bool equal_cost(const Interval& ratio);

// Compares the costs of all pairs by sign tests, corrected for their number (Holm), so that all claims of "surely
// cheaper" together have the level `family_level`. Errors within a thousandth are equal, and an error that is smaller
// by less than a hundredth is not better. A cost that is higher by less than 3 %, by the median of the ratios, counts
// as equal. So does one that differs by no more than `noise`, the control's: what the same rung shows against itself
// is no difference between rungs.
std::vector<Verdict> pareto_front(std::span<const Point> points, double noise = 0);
inline constexpr std::size_t fewest_rounds = 7;  // the minimum for an interval of the median
// The fewest rounds in which every comparison of this many rungs can be sure.
std::size_t rounds_for(std::size_t rungs);

// The control measurement: the same rung timed twice under two names.
struct Control {
    Interval ratio{1, 1, 1};
    double noise = 0;    // how far the interval reaches from 1
    bool noisy = false;  // it reaches further than a tenth: no costs are compared
};
// Compares the times of a rung with those of its second timing, `again`, in the same rounds.
Control control(std::span<const double> first, std::span<const double> again, std::uint64_t seed = 1);

// For each rung of a ladder, whether it is surely more expensive than both neighbours. Always false for the first and
// the last.
std::vector<bool> cliffs(std::span<const Point> ladder);

}  // namespace snell::accuracy
