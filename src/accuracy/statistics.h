// Medians, their uncertainty, and ratios of values measured in the same rounds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace snell::accuracy {

// For an even number of values, the mean of the two in the middle; NaN for none.
double median(std::span<const double> values);
// Median absolute deviation from the median, not scaled.
double mad(std::span<const double> values);
// Standard deviation divided by the mean; 0 for fewer than two values.
double variation(std::span<const double> values);

// A median and its 95 % confidence interval by bootstrapping: the interval that contains 95 % of the medians of
// resampled values.
struct Interval {
    double low = 0, middle = 0, high = 0;

    bool contains(double value) const { return low <= value && value <= high; }
    double width() const { return high - low; }
};

// Computes the interval from `resamples` samples with replacement; the same values and seed give the same interval.
// Fewer than five values allow no such estimate: the interval is then a factor of 1.5 wider than the values on both
// sides (for positive values), which deviations on a quiet machine do not exceed. For no values, all members are NaN.
Interval bootstrap_median(std::span<const double> values, std::uint64_t seed = 1, int resamples = 2000);

// The quotients a[i] / b[i] of the rounds that both took part in (a value that is not positive is missing). A load of
// the machine that lasts for a whole round cancels out.
std::vector<double> quotients(std::span<const double> a, std::span<const double> b);
// The interval of their median.
Interval paired_ratio(std::span<const double> a, std::span<const double> b, std::uint64_t seed = 1,
                      int resamples = 2000);

// The probability that ratios of equal costs lie on one side of 1 as clearly as these (two-sided sign test; ratios of 1
// are left out). 0 if all differ from 1 by more than a factor of 1.5 to the same side, however few they are.
double chance_of_signs(std::span<const double> ratios);
// Holm's step-down correction: which of these probabilities are small enough that all claims together have the level.
std::vector<bool> holm(std::span<const double> chances, double level);

}  // namespace snell::accuracy
