// Which rungs are worth their time, given how uncertain times are.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "src/accuracy/statistics.h"

namespace snell::accuracy {

inline constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

// One rung: its error against the reference (any unit, 0 is exact) and its times by round, in milliseconds; a round
// that it did not take part in is 0. Rungs of one front took part in the same rounds.
struct Point {
    double error = 0;
    std::vector<double> times;
};

enum class Standing {
    front,       // none of what follows
    dominated,   // `by` is surely cheaper, and not worse
    saves_none,  // `by` is more exact at equal cost: nothing is saved here
    unknown,     // error or time is no number
};

struct Verdict {
    Standing standing = Standing::front;
    std::size_t by = nobody;
    bool operator==(const Verdict&) const = default;
};

// Surely cheaper: the whole interval of the ratio lies below 1. Equal: it contains 1.
bool surely_cheaper(const Interval& ratio);
bool equal_cost(const Interval& ratio);

// Errors within a thousandth are the same; better by less than a hundredth is no better. What is less than 3 %
// dearer, by the median of its ratios, costs the same.
std::vector<Verdict> pareto_front(std::span<const Point> points, std::uint64_t seed = 1);
// Another run might well draw another front: the intervals of some rung that nothing surely beats lie on both sides of
// these 3 %.
bool undecided(std::span<const Point> points, std::uint64_t seed = 1);

// The control: one rung that was timed twice under two names.
struct Control {
    Interval ratio{1, 1, 1};
    bool noisy = false;  // 1 is not within the interval, or the interval is wider than 5 %
};
Control control(std::span<const double> first, std::span<const double> again, std::uint64_t seed = 1);

// By place in a ladder: surely dearer than both neighbours. The first and last never are.
std::vector<bool> cliffs(std::span<const Point> ladder, std::uint64_t seed = 1);

}  // namespace snell::accuracy
