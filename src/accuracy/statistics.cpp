#include "src/accuracy/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "parser/text/ranges.h"

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
    if (values.size() < few) return {ranges::min(values) / apart, middle, ranges::max(values) * apart};
    std::mt19937_64 random(seed);
    std::vector<double> drawn(values.size()), medians;
    for (int i = 0; i < resamples; ++i) {
        // uniform_int_distribution gives different numbers with different standard libraries.
        for (double& value : drawn) value = values[random() % values.size()];
        medians.push_back(median_in_place(drawn));
    }
    ranges::sort(medians);
    const auto at = [&](double quantile) {
        return medians[static_cast<std::size_t>(quantile * static_cast<double>(medians.size() - 1) + .5)];
    };
    return {std::min(at(.025), middle), middle, std::max(at(.975), middle)};
}

std::vector<double> quotients(std::span<const double> a, std::span<const double> b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] > 0 && b[i] > 0) ratios.push_back(a[i] / b[i]);
    return ratios;
}

Interval paired_ratio(std::span<const double> a, std::span<const double> b, std::uint64_t seed, int resamples) {
    return bootstrap_median(quotients(a, b), seed, resamples);
}

double chance_of_signs(std::span<const double> ratios) {
    if (!ratios.empty() && (ranges::max(ratios) < 1 / apart || ranges::min(ratios) > apart)) return 0;
    const auto below = ranges::count_if(ratios, [](double r) { return r < 1; });
    const auto above = ranges::count_if(ratios, [](double r) { return r > 1; });
    const auto n = static_cast<double>(below + above), fewer = static_cast<double>(std::min(below, above));
    double sum = 0;
    for (double k = 0; k <= fewer; ++k)
        sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) - n * std::log(2.0));
    return std::min(2 * sum, 1.0);
}

std::vector<bool> holm(std::span<const double> chances, double level) {
    std::vector<std::size_t> order(chances.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    ranges::sort(order, {}, [&](std::size_t i) { return chances[i]; });
    std::vector<bool> sure(chances.size(), false);
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (!(chances[order[k]] <= level / static_cast<double>(order.size() - k))) break;
        sure[order[k]] = true;
    }
    return sure;
}

}  // namespace snell::accuracy
