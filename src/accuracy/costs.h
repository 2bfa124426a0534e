// What is said of two costs: one rule for every table, plot, advice and merge.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "src/accuracy/statistics.h"

namespace snell::accuracy {

enum class Cost : std::uint8_t { cheaper, dearer, equal, not_told };
// Such as "not told apart".
std::string_view name(Cost cost);

// Costs whose quotient is surely nearer to 1 are equal, although one may surely be the smaller.
inline constexpr double same_cost = .03;
// The probability that any of the claims that a table makes of its costs is wrong, all of its pairs together.
inline constexpr double family_level = .05;

// The first cost compared with the second, by the interval of their ratio: *equal* if all of it is within `within` of
// 1 (a test of equivalence), *cheaper* or *dearer* if all of it is on one side; otherwise nothing is told. What a rung
// shows against itself, `noise`, is neither a difference nor known to be none.
Cost compare_costs(const Interval& ratio, double noise = 0, double within = same_cost);

// The control measurement: the same rung timed twice under two names.
struct Control {
    Interval ratio{1, 1, 1};
    double noise = 0;  // by how much of 1 the interval, or its reciprocal, exceeds 1
};
// Compares the times of a rung with those of its second timing, `again`, in the same rounds.
Control control(std::span<const double> first, std::span<const double> again);

// All pairs of rungs, by their times in the same rounds; 0 marks a round that one did not take part in. Intervals are
// so wide that all claims together have the level `family_level` (Bonferroni).
class Costs {
public:
    Costs() = default;
    Costs(std::span<const std::vector<double>> times, double noise);

    // Of a relative to b.
    Cost of(std::size_t a, std::size_t b) const {
        return a < count_ && b < count_ ? cost_[a * count_ + b] : Cost::not_told;
    }
    // The median of the ratios; 1 if no round is common.
    double middle(std::size_t a, std::size_t b) const { return middle_[a * count_ + b]; }

private:
    std::size_t count_ = 0;
    std::vector<Cost> cost_;
    std::vector<double> middle_;
};

inline constexpr std::size_t fewest_rounds = 7;  // the minimum for an interval of the median
// The fewest rounds in which every comparison of this many rungs can be sure.
std::size_t rounds_for(std::size_t rungs);

}  // namespace snell::accuracy
