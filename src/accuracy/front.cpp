#include "src/accuracy/front.h"

#include <algorithm>
#include <cmath>

namespace snell::accuracy {

namespace {

constexpr double same_error = 1e-3, better_error = 1e-2, same_cost = 1.03, widest_control = .05;

bool measured(const Point& point) {
    return std::isfinite(point.error) && point.error >= 0 &&
           std::ranges::any_of(point.times, [](double t) { return t > 0; });
}

// Each pair's ratio is computed once; that of the swapped pair is its reciprocal.
class Ratios {
public:
    Ratios(std::span<const Point> points, std::uint64_t seed) : count_(points.size()), ratios_(count_ * count_) {
        for (std::size_t i = 0; i < count_; ++i)
            for (std::size_t j = i + 1; j < count_; ++j) {
                const Interval r = paired_ratio(points[i].times, points[j].times, seed);
                ratios_[i * count_ + j] = r;
                ratios_[j * count_ + i] = {1 / r.high, 1 / r.middle, 1 / r.low};
            }
    }
    const Interval& of(std::size_t a, std::size_t b) const { return ratios_[a * count_ + b]; }

private:
    std::size_t count_;
    std::vector<Interval> ratios_;
};

// Relations of one rung to another; `cost` is the other's cost divided by its own.
bool is_better(const Point& other, const Point& own) { return other.error < own.error * (1 - better_error); }
bool is_no_worse(const Point& other, const Point& own) { return other.error <= own.error * (1 + same_error); }
bool costs_no_more(const Interval& cost) { return equal_cost(cost) || cost.middle <= same_cost; }

}  // namespace

bool surely_cheaper(const Interval& ratio) { return ratio.high < 1; }
bool equal_cost(const Interval& ratio) { return ratio.contains(1); }

std::vector<Verdict> pareto_front(std::span<const Point> points, std::uint64_t seed) {
    const Ratios ratios(points, seed);
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
            if (first || ratios.of(j, verdict.by).middle < 1) verdict = {standing, j};
        };
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j == i || !measured(points[j])) continue;
            const Interval& cost = ratios.of(j, i);
            if (is_no_worse(points[j], points[i]) && surely_cheaper(cost))
                blame(Standing::dominated, j);
            else if (is_better(points[j], points[i]) && costs_no_more(cost))
                blame(Standing::saves_none, j);
        }
    }
    return verdicts;
}

bool undecided(std::span<const Point> points, std::uint64_t seed) {
    const Ratios ratios(points, seed);
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool beaten = false, open = false;
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j == i || !measured(points[i]) || !measured(points[j])) continue;
            const Interval& cost = ratios.of(j, i);
            const bool better = is_better(points[j], points[i]);
            beaten = beaten || (is_no_worse(points[j], points[i]) && surely_cheaper(cost)) ||
                     (better && cost.high <= same_cost);
            open = open || (better && cost.low <= same_cost && cost.high > same_cost);
        }
        if (open && !beaten) return true;
    }
    return false;
}

Control control(std::span<const double> first, std::span<const double> again, std::uint64_t seed) {
    Control result;
    result.ratio = paired_ratio(again, first, seed);
    result.noisy = !result.ratio.contains(1) || !(result.ratio.width() <= widest_control);
    return result;
}

std::vector<bool> cliffs(std::span<const Point> ladder, std::uint64_t seed) {
    std::vector<bool> result(ladder.size(), false);
    for (std::size_t i = 1; i + 1 < ladder.size(); ++i)
        result[i] = surely_cheaper(paired_ratio(ladder[i - 1].times, ladder[i].times, seed)) &&
                    surely_cheaper(paired_ratio(ladder[i + 1].times, ladder[i].times, seed));
    return result;
}

}  // namespace snell::accuracy
