#include "src/accuracy/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

double median_in_place(std::vector<double>& values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 != 0) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace

double median(std::span<const double> values) {
    std::vector<double> copy(values.begin(), values.end());
    return median_in_place(copy);
}

double mad(std::span<const double> values) {
    const double middle = median(values);
    std::vector<double> deviations;
    for (double value : values) deviations.push_back(std::abs(value - middle));
    return median_in_place(deviations);
}

double variation(std::span<const double> values) {
    if (values.size() < 2) return 0;
    const double n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (double value : values) mean += value / n;
    for (double value : values) squares += (value - mean) * (value - mean);
    return mean > 0 ? std::sqrt(squares / (n - 1)) / mean : 0;
}

Interval median_interval(std::span<const double> values, double level) {
    const double middle = median(values);
    if (values.empty()) return {middle, middle, middle};
    std::vector<double> sorted(values.begin(), values.end());
    ranges::sort(sorted);
    // The true median lies below the value at `ends` if at most so many of n tosses of a coin are heads.
    const auto n = static_cast<double>(values.size());
    double chance = 0;
    std::size_t ends = 0;
    for (double k = 0; k < n / 2; ++k, ++ends) {
        chance += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
        if (2 * chance > level * (1 + 1e-9)) break;
    }
    if (ends == 0) return {0, middle, std::numeric_limits<double>::infinity()};
    return {sorted[ends - 1], middle, sorted[sorted.size() - ends]};
}

std::vector<double> quotients(std::span<const double> a, std::span<const double> b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] > 0 && b[i] > 0) ratios.push_back(a[i] / b[i]);
    return ratios;
}

Interval paired_ratio(std::span<const double> a, std::span<const double> b, double level) {
    return median_interval(quotients(a, b), level);
}

}  // namespace snell::accuracy
