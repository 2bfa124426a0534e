#include "src/accuracy/costs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

double pairs_of(std::size_t rungs) {
    const auto n = static_cast<double>(rungs);
    return std::max(n * (n - 1) / 2, 1.);
}

Interval reciprocal(const Interval& ratio) { return {1 / ratio.high, 1 / ratio.middle, 1 / ratio.low}; }

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
    const auto timed = ranges::count_if(
        times, [](const auto& of) { return ranges::any_of(of, [](double time) { return time > 0; }); });
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

}  // namespace snell::accuracy
