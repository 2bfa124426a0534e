#include "src/accuracy/front.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

constexpr double same_error = 1e-3, better_error = 1e-2;

bool measured(const Point& point) {
    return point.error >= 0 && ranges::any_of(point.times, [](double t) { return t > 0; });
}

bool is_better(const Point& other, const Point& own) { return other.error < own.error * (1 - better_error); }
bool is_no_worse(const Point& other, const Point& own) { return other.error <= own.error * (1 + same_error); }

}  // namespace

Costs costs_of(std::span<const Point> points, double noise) {
    std::vector<std::vector<double>> times;
    for (const Point& point : points) times.push_back(point.times);
    return {times, noise};
}

std::vector<Verdict> pareto_front(std::span<const Point> points, const Costs& costs) {
    std::vector<Verdict> verdicts(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!measured(points[i])) {
            verdicts[i] = {Standing::unknown, nobody};
            continue;
        }
        // Of several reasons the surest one is shown, and of several rungs the cheapest.
        const auto blame = [&](Standing standing, std::size_t j) {
            Verdict& verdict = verdicts[i];
            if (verdict.standing != Standing::front && verdict.standing < standing) return;
            if (verdict.standing != standing || costs.middle(j, verdict.by) < 1) verdict = {standing, j};
        };
        for (std::size_t j = 0; j < points.size(); ++j) {
            if (j == i || !measured(points[j])) continue;
            const Cost cost = costs.of(i, j);
            if (is_no_worse(points[j], points[i]) && cost == Cost::dearer)
                blame(Standing::dominated, j);
            else if (is_better(points[j], points[i]) && cost != Cost::cheaper)
                blame(cost == Cost::equal ? Standing::saves_none : Standing::unsure, j);
        }
        if (std::isinf(points[i].error) && verdicts[i].standing == Standing::front)
            verdicts[i] = {Standing::unknown, nobody};
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
