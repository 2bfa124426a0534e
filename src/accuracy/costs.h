// Costs from times: medians and their uncertainty, what is said of two of them, and which rungs are worth their time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace snell::accuracy {

// Medians, their uncertainty, and ratios of values measured in the same rounds.

// For an even number of values, the mean of the two in the middle; NaN for none.
double median(std::span<const double> values);
// The value that so much of all of them do not exceed; 0 for none. They are put in another order.
template <class T>
T quantile(std::vector<T>& values, double part) {
    if (values.empty()) return 0;
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + .5);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}
// Median absolute deviation from the median, not scaled.
double mad(std::span<const double> values);
// Standard deviation divided by the mean; 0 for fewer than two values.
double variation(std::span<const double> values);

// A median, and the interval in which the true one lies.
struct Interval {
    double low = 0, middle = 0, high = 0;

    bool contains(double value) const { return low <= value && value <= high; }
    double width() const { return high - low; }
    // False if there were too few values.
    bool known() const { return std::isfinite(high); }
};

// The interval misses the median of what the values are drawn from with a probability of at most `level`, half of it at
// either end, whatever the distribution is (order statistics, as in a sign test). The values are positive and
// independent. Of too few of them nothing is known: from 0 to infinity. For none, all members are NaN.
Interval median_interval(std::span<const double> values, double level = .05);

// A time of 0 marks a round that something did not take part in. The others:
std::vector<double> taken(std::span<const double> times);
// The quotients a[i] / b[i] of the rounds that both took part in. A load of the machine that lasts for a whole round
// cancels out.
std::vector<double> quotients(std::span<const double> a, std::span<const double> b);
// The interval of their median.
Interval paired_ratio(std::span<const double> a, std::span<const double> b, double level = .05);
// The median of the differences a[i] - b[i] of these rounds; NaN if there are none.
double paired_difference(std::span<const double> a, std::span<const double> b);

// What is said of two costs: one rule for every table, plot, advice and merge.

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

// Decides which rungs are worth their time, given the uncertainty of the times.

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
    saves_none,  // `by`, on the front, is more exact at equal cost, so this rung saves nothing
    unsure,      // `by`, on the front, is more exact, and this rung is not surely cheaper
    unknown,     // error or time is not a number; or the error is infinite, and no other rung is as cheap
};

struct Verdict {
    Standing standing = Standing::front;
    std::size_t by = nobody;
    bool operator==(const Verdict&) const = default;
};

Costs costs_of(std::span<const Point> points, double noise = 0);

// From the most exact rung on, those that no rung surely beats, and that are surely cheaper than all that are on the
// front already: so rungs that are too close to be told apart do not keep a clearly cheaper one away. Errors within a
// thousandth are equal, and an error that is smaller by less than a hundredth is not better. `costs` are those of the
// points.
std::vector<Verdict> pareto_front(std::span<const Point> points, const Costs& costs);

// For each rung of a ladder, whether it is surely more expensive than both neighbours. Always false for the first and
// the last.
std::vector<bool> cliffs(std::size_t rungs, const Costs& costs);

}  // namespace snell::accuracy
