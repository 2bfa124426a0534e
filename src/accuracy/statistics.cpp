#include "src/accuracy/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace snell::accuracy {

namespace {

// For frames on a shared machine: larger differences are not chance.
constexpr std::size_t few = 5;
constexpr double apart = 1.5;

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

Interval bootstrap_median(std::span<const double> values, std::uint64_t seed, int resamples) {
    const double middle = median(values);
    if (values.empty()) return {middle, middle, middle};
    if (values.size() < few) return {std::ranges::min(values) / apart, middle, std::ranges::max(values) * apart};
    std::mt19937_64 random(seed);
    std::vector<double> drawn(values.size()), medians;
    for (int i = 0; i < resamples; ++i) {
        // uniform_int_distribution gives different numbers with different standard libraries.
        for (double& value : drawn) value = values[random() % values.size()];
        medians.push_back(median_in_place(drawn));
    }
    std::ranges::sort(medians);
    const auto at = [&](double quantile) {
        return medians[static_cast<std::size_t>(quantile * static_cast<double>(medians.size() - 1) + .5)];
    };
    return {std::min(at(.025), middle), middle, std::max(at(.975), middle)};
}

Interval paired_ratio(std::span<const double> a, std::span<const double> b, std::uint64_t seed, int resamples) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] > 0 && b[i] > 0) ratios.push_back(a[i] / b[i]);
    return bootstrap_median(ratios, seed, resamples);
}

}  // namespace snell::accuracy
