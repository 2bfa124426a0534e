// Medians, their uncertainty, and ratios of what was measured in the same rounds.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace snell::accuracy {

// Of an even number of values the mean of the middle two; of none NaN.
double median(std::span<const double> values);
// Median absolute deviation from the median, not scaled.
double mad(std::span<const double> values);
// Standard deviation over mean; 0 for fewer than two values.
double variation(std::span<const double> values);

// A median, and where 95 % of the medians of as many values drawn with replacement lie.
struct Interval {
    double low = 0, middle = 0, high = 0;

    bool contains(double value) const { return low <= value && value <= high; }
    double width() const { return high - low; }
};

// By `resamples` draws from a generator with that seed: the same values give the same interval. Of fewer than five
// values no interval can be told: it is half as much again as the largest, and less than the smallest, of positive
// ones, which no quiet machine exceeds. Of no values: nothing but NaN.
Interval bootstrap_median(std::span<const double> values, std::uint64_t seed = 1, int resamples = 2000);

// Of the quotients a[i] / b[i] of the rounds that both took part in (a value that is not positive is an absent
// one). Load of the machine that lasts for a round cancels.
Interval paired_ratio(std::span<const double> a, std::span<const double> b, std::uint64_t seed = 1,
                      int resamples = 2000);

}  // namespace snell::accuracy
