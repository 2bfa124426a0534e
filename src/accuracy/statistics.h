// Medians, their uncertainty, and ratios of values measured in the same rounds.
#pragma once

#include <cmath>
#include <span>
#include <vector>

namespace snell::accuracy {

// For an even number of values, the mean of the two in the middle; NaN for none.
double median(std::span<const double> values);
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

// The quotients a[i] / b[i] of the rounds that both took part in (a value that is not positive is missing). A load of
// the machine that lasts for a whole round cancels out.
std::vector<double> quotients(std::span<const double> a, std::span<const double> b);
// The interval of their median.
Interval paired_ratio(std::span<const double> a, std::span<const double> b, double level = .05);

}  // namespace snell::accuracy
