#include "src/accuracy/costs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

double pairs_of(std::size_t rungs) {
    const auto n = static_cast<double>(rungs);
    return std::max(n * (n - 1) / 2, 1.);
}

Interval reciprocal(const Interval& ratio) { return {1 / ratio.high, 1 / ratio.middle, 1 / ratio.low}; }

double median_in_place(std::vector<double>& values) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 != 0) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

template <class Compare>
std::vector<double> paired(std::span<const double> a, std::span<const double> b, const Compare& compare) {
    std::vector<double> result;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (a[i] > 0 && b[i] > 0) result.push_back(compare(a[i], b[i]));
    return result;
}

constexpr double same_error = 1e-3, better_error = 1e-2;

bool measured(const Point& point) { return point.error >= 0 && !taken(point.times).empty(); }

bool is_better(const Point& other, const Point& own) { return other.error < own.error * (1 - better_error); }
bool is_no_worse(const Point& other, const Point& own) { return other.error <= own.error * (1 + same_error); }

}  // namespace

std::string_view name(Cost cost) {
    constexpr std::array<std::string_view, 4> names{"cheaper", "dearer", "equal", "not told apart"};
    return names[static_cast<std::size_t>(cost)];
}

Cost compare_costs(const Interval& ratio, double noise, double within) {
    const double sure = 1 + noise, same = 1 + within;
    if (ratio.low * same >= 1 && ratio.high <= same && noise <= within) return Cost::equal;
    if (ratio.high * sure < 1) return Cost::cheaper;
    return ratio.low > sure ? Cost::dearer : Cost::not_told;
}

Control control(std::span<const double> first, std::span<const double> again) {
    Control result;
    result.ratio = paired_ratio(again, first);
    result.noise = std::max(result.ratio.high, 1 / result.ratio.low) - 1;
    return result;
}

Costs::Costs(std::span<const std::vector<double>> times, double noise)
    : count_(times.size()), cost_(count_ * count_, Cost::not_told), middle_(count_ * count_, 1) {
    const auto timed = ranges::count_if(times, [](const auto& of) { return !taken(of).empty(); });
    const double level = family_level / pairs_of(static_cast<std::size_t>(timed));
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Interval ratio = paired_ratio(times[i], times[j], level);
            if (std::isnan(ratio.middle)) continue;
            middle_[i * count_ + j] = ratio.middle;
            middle_[j * count_ + i] = 1 / ratio.middle;
            cost_[i * count_ + j] = compare_costs(ratio, noise);
            cost_[j * count_ + i] = compare_costs(reciprocal(ratio), noise);
        }
}

std::size_t rounds_for(std::size_t rungs) {
    return static_cast<std::size_t>(std::ceil(1 + std::log2(pairs_of(rungs) / family_level)));
}

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

std::vector<double> taken(std::span<const double> times) {
    std::vector<double> result;
    ranges::copy_if(times, std::back_inserter(result), [](double time) { return time > 0; });
    return result;
}

std::vector<double> quotients(std::span<const double> a, std::span<const double> b) {
    return paired(a, b, std::divides<>());
}

double paired_difference(std::span<const double> a, std::span<const double> b) {
    return median(paired(a, b, std::minus<>()));
}

Interval paired_ratio(std::span<const double> a, std::span<const double> b, double level) {
    return median_interval(quotients(a, b), level);
}

Costs costs_of(std::span<const Point> points, double noise) {
    std::vector<std::vector<double>> times;
    for (const Point& point : points) times.push_back(point.times);
    return {times, noise};
}

std::vector<Verdict> pareto_front(std::span<const Point> points, const Costs& costs) {
    std::vector<Verdict> verdicts(points.size());
    // Of several reasons the surest one is shown, and of several rungs the cheapest.
    const auto blame = [&](std::size_t i, Standing standing, std::size_t j) {
        Verdict& verdict = verdicts[i];
        if (verdict.standing != Standing::front && verdict.standing < standing) return;
        if (verdict.standing != standing || costs.middle(j, verdict.by) < 1) verdict = {standing, j};
    };
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!measured(points[i])) {
            verdicts[i] = {Standing::unknown, nobody};
            continue;
        }
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i && measured(points[j]) && is_no_worse(points[j], points[i]) && costs.of(i, j) == Cost::dearer)
                blame(i, Standing::dominated, j);
        if (verdicts[i].standing == Standing::front) order.push_back(i);
    }
    ranges::stable_sort(order, {}, [&](std::size_t i) { return points[i].error; });
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        for (const std::size_t j : front)
            if (const Cost cost = costs.of(i, j); is_better(points[j], points[i]) && cost != Cost::cheaper)
                blame(i, cost == Cost::equal ? Standing::saves_none : Standing::unsure, j);
        if (verdicts[i].standing != Standing::front) continue;
        if (std::isinf(points[i].error))
            verdicts[i] = {Standing::unknown, nobody};
        else
            front.push_back(i);
    }
    return verdicts;
}

std::vector<bool> cliffs(std::size_t rungs, const Costs& costs) {
    std::vector<bool> result(rungs, false);
    for (std::size_t i = 1; i + 1 < rungs; ++i)
        result[i] = costs.of(i, i - 1) == Cost::dearer && costs.of(i, i + 1) == Cost::dearer;
    return result;
}

}  // namespace snell::accuracy
