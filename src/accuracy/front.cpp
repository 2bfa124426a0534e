#include "src/accuracy/front.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

constexpr double same_error = 1e-3, better_error = 1e-2, same_cost = 1.03, noisiest_control = .1;

bool measured(const Point& point) {
    return point.error >= 0 && ranges::any_of(point.times, [](double t) { return t > 0; });
}

// The costs of all pairs.
class Costs {
public:
    explicit Costs(std::span<const Point> points, double noise = 0)
        : count_(points.size()),
          same_(std::max(same_cost, 1 + noise)),
          middle_(count_ * count_, 1),
          cheaper_(count_ * count_, false) {
        std::vector<std::size_t> pairs;
        std::vector<double> chances;
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t j = i + 1; j < count_; ++j) {
                const std::vector<double> ratios = quotients(points[i].times, points[j].times);
                if (ratios.empty()) continue;
                middle_[i * count_ + j] = median(ratios);
                middle_[j * count_ + i] = 1 / median(ratios);
                pairs.push_back(i * count_ + j);
                chances.push_back(chance_of_signs(ratios));
            }
        const std::vector<bool> sure = holm(chances, family_level);
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const std::size_t i = pairs[k] / count_, j = pairs[k] % count_;
            cheaper_[i * count_ + j] = sure[k] && middle(j, i) > 1 + noise;
            cheaper_[j * count_ + i] = sure[k] && middle(i, j) > 1 + noise;
        }
    }
    // The cost of a relative to that of b.
    double middle(std::size_t a, std::size_t b) const { return middle_[a * count_ + b]; }
    bool surely_cheaper(std::size_t a, std::size_t b) const { return cheaper_[a * count_ + b]; }
    bool no_more(std::size_t a, std::size_t b) const { return !surely_cheaper(b, a) || middle(a, b) <= same_; }

private:
    std::size_t count_;
    double same_;  // costs with no larger quotient are equal
    std::vector<double> middle_;
    std::vector<bool> cheaper_;
};

bool is_better(const Point& other, const Point& own) { return other.error < own.error * (1 - better_error); }
bool is_no_worse(const Point& other, const Point& own) { return other.error <= own.error * (1 + same_error); }

}  // namespace

bool equal_cost(const Interval& ratio) { return ratio.contains(1); }

std::vector<Verdict> pareto_front(std::span<const Point> points, double noise) {
    const Costs costs(points, noise);
    std::vector<Verdict> verdicts(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!measured(points[i])) {
            verdicts[i] = {Standing::unknown, nobody};
            continue;
        }
        // Of several reasons, the cheapest rung is shown to the reader.
        const auto blame = [&](Standing standing, std::size_t j) {
            Verdict& verdict = verdicts[i];
            if (verdict.standing == Standing::dominated && standing != Standing::dominated) return;
            const bool first = verdict.standing != standing;
            if (first || costs.middle(j, verdict.by) < 1) verdict = {standing, j};
        };
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j == i || !measured(points[j])) continue;
            if (is_no_worse(points[j], points[i]) && costs.surely_cheaper(j, i))
                blame(Standing::dominated, j);
            else if (is_better(points[j], points[i]) && costs.no_more(j, i))
                blame(Standing::saves_none, j);
        }
        if (std::isinf(points[i].error) && verdicts[i].standing == Standing::front)
            verdicts[i] = {Standing::unknown, nobody};
    }
    return verdicts;
}

std::size_t rounds_for(std::size_t rungs) {
    const double pairs = static_cast<double>(rungs * (rungs - std::min<std::size_t>(rungs, 1))) / 2;
    return static_cast<std::size_t>(std::ceil(1 + std::log2(std::max(pairs, 1.0) / family_level)));
}

Control control(std::span<const double> first, std::span<const double> again, std::uint64_t seed) {
    Control result;
    result.ratio = paired_ratio(again, first, seed);
    result.noise = std::max(result.ratio.high - 1, 1 - result.ratio.low);
    result.noisy = !(result.noise <= noisiest_control);
    return result;
}

std::vector<bool> cliffs(std::span<const Point> ladder) {
    const Costs costs(ladder);
    std::vector<bool> result(ladder.size(), false);
    for (std::size_t i = 1; i + 1 < ladder.size(); ++i)
        result[i] = costs.surely_cheaper(i - 1, i) && costs.surely_cheaper(i + 1, i);
    return result;
}

}  // namespace snell::accuracy
