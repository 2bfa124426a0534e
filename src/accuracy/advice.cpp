#include "src/accuracy/advice.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

#include "parser/text/ranges.h"
#include "src/runtime/resources/counters.h"

namespace snell::accuracy {

namespace {

constexpr std::size_t few_combinations = 32, most_steps = 12;
constexpr double as_exact = 1.01;  // errors that differ by less than this factor are considered equal

bool exact_enough(const SweepResult& sweep, const RungResult& rung, const Wish& wish) {
    const double residual = sweep.residual.value_or(std::numeric_limits<double>::infinity());
    return (!wish.error || rung.own.light.rmse + residual <= *wish.error) &&
           (!wish.alone || rung.alone.rmse <= *wish.alone);
}
bool quick_enough(const RungResult& rung, const Wish& wish) {
    return !wish.milliseconds || rung.high <= *wish.milliseconds;
}

// `centre`, and all combinations that differ from it in one ladder.
std::vector<Rungs> neighbours(const Scene& scene, const Rungs& centre) {
    std::vector<Rungs> near{centre};
    for (std::size_t i = 0; i < centre.size(); ++i)
        for (std::size_t rung = 0; rung < scene.ladders[i].rungs.size(); ++rung)
            if (rung != centre[i]) {
                near.push_back(centre);
                near.back()[i] = rung;
            }
    return near;
}

class Adviser {
public:
    Adviser(Bench& bench, const Rungs& now, const MeasureOptions& options)
        : bench_(bench), now_(now), options_(options), ladders_(now.size()) {
        std::iota(ladders_.begin(), ladders_.end(), std::size_t{0});
    }

    Counsel run(std::span<const Wish> wishes) {
        const bool few = count_combinations(bench_.scene(), ladders_) <= few_combinations;
        if (few) measure_all(all_combinations(bench_.scene(), ladders_), options_.seconds);
        for (std::size_t i = 0; i < wishes.size(); ++i) {
            const double share = left() / static_cast<double>(wishes.size() - i);
            counsel_.advice.push_back(few ? of_all(wishes[i]) : climb(wishes[i], share));
        }
        return std::move(counsel_);
    }

private:
    double left() const { return options_.seconds - 1e-3 * watch_.milliseconds(); }

    const SweepResult& measure_all(std::vector<Rungs> all, double seconds) {
        MeasureOptions measuring = options_;
        measuring.seconds = std::max(seconds, .1);
        counsel_.sweeps.push_back(
            measure(bench_, combination_sweep(bench_.scene(), ladders_, std::move(all), now_), measuring));
        return counsel_.sweeps.back();
    }

    Advice conclude(const Wish& wish, bool everything, bool settled) const {
        Advice advice{.wish = wish, .everything = everything, .sweep = counsel_.sweeps.size() - 1};
        const SweepResult& sweep = counsel_.sweeps.back();
        const auto best = choose(sweep, wish);
        advice.rung = best.value_or(sweep.sweep.current);
        advice.known = best.has_value();
        advice.met = best && fulfils(sweep, sweep.rungs[*best], wish);
        advice.settled = best && settled && !sweep.interrupted && !sweep.few_rounds;
        return advice;
    }

    Advice of_all(const Wish& wish) const { return conclude(wish, true, true); }

    // Each step compares rungs within one sweep, whose times are from the same rounds.
    Advice climb(const Wish& wish, double seconds) {
        const double end = left() - seconds;
        std::vector<Rungs> seen;
        Rungs centre = last_rungs(bench_.scene());
        for (std::size_t step = 0; step < most_steps; ++step) {
            const SweepResult& sweep = measure_all(neighbours(bench_.scene(), centre), seconds / 4);
            const auto best = choose(sweep, wish);
            if (!best || sweep.interrupted) break;
            const Rungs& found = sweep.sweep.rungs[*best].variant.rungs;
            // Noise may lead the search in a circle; a combination that was visited before is as good.
            if (found == centre || ranges::find(seen, found) != seen.end()) return conclude(wish, false, true);
            if (left() <= end) break;
            seen.push_back(centre);
            centre = found;
        }
        return conclude(wish, false, false);
    }

    Bench& bench_;
    Rungs now_;
    const MeasureOptions& options_;
    std::vector<std::size_t> ladders_;  // all
    Counsel counsel_;
    runtime::Stopwatch watch_;
};

}  // namespace

bool fulfils(const SweepResult& sweep, const RungResult& rung, const Wish& wish) {
    return exact_enough(sweep, rung, wish) && quick_enough(rung, wish);
}

std::optional<std::size_t> choose(const SweepResult& sweep, const Wish& wish) {
    using Places = std::vector<std::size_t>;
    const auto rung = [&](std::size_t i) -> const RungResult& { return sweep.rungs[i]; };
    const auto error = [&](std::size_t i) {
        return wish.alone ? rung(i).alone.rmse : std::max(rung(i).own.light.rmse, sweep.residual.value_or(0));
    };
    const auto cost = [&](std::size_t i) { return rung(i).ratio.middle; };
    const auto those = [](const Places& of, auto which) {
        Places found;
        ranges::copy_if(of, std::back_inserter(found), which);
        return found;
    };
    // Of those whose errors are equal, the one that is nearest to the last rungs: a picture may hide what they do.
    const auto most_exact = [&](const Places& of) {
        const double least = error(*ranges::min_element(of, {}, error));
        const Places alike = those(of, [&](std::size_t i) { return !(error(i) > least * as_exact); });
        return *ranges::max_element(
            alike, {}, [&](std::size_t i) { return std::reduce(rung(i).steps.begin(), rung(i).steps.end()); });
    };
    Places all;
    for (std::size_t i = 0; i < sweep.rungs.size(); ++i)
        if (rung(i).drawn && rung(i).rounds > 0 && std::isfinite(rung(i).own.light.rmse)) all.push_back(i);
    if (all.empty() || !sweep.cannot_say.empty()) return std::nullopt;
    const Places exact = those(all, [&](std::size_t i) { return exact_enough(sweep, rung(i), wish); });
    const Places good = those(exact, [&](std::size_t i) { return quick_enough(rung(i), wish); });
    if (good.empty()) return exact.empty() ? most_exact(all) : *ranges::min_element(exact, {}, cost);
    Places wanted = good;
    if (wish.milliseconds) {
        const double least = error(*ranges::min_element(good, {}, error));
        wanted = those(good, [&](std::size_t i) { return !(error(i) > least * as_exact); });
    }
    // Of those that are not surely dearer than the cheapest, which one is cheaper is chance.
    const std::size_t cheapest = *ranges::min_element(wanted, {}, cost);
    return most_exact(
        those(wanted, [&](std::size_t i) { return i == cheapest || sweep.costs.of(i, cheapest) != Cost::dearer; }));
}

std::optional<std::size_t> choose_surely(const SweepResult& sweep, const Wish& wish) {
    const auto best = choose(sweep, wish);
    const std::size_t now = sweep.sweep.current;
    if (!best || wish.milliseconds || *best == now || !fulfils(sweep, sweep.rungs[now], wish)) return best;
    if (sweep.rungs[now].rounds == 0) return std::nullopt;  // what anything saves is not known
    return sweep.costs.of(*best, now) == Cost::cheaper ? best : now;
}

Counsel advise(Bench& bench, const Rungs& now, std::span<const Wish> wishes, const MeasureOptions& options) {
    return Adviser(bench, now, options).run(wishes);
}

std::vector<std::string> choices(const Scene& scene, const Rungs& rungs) {
    std::vector<std::string> text;
    for (std::size_t i = 0; i < rungs.size(); ++i)
        text.push_back(scene.ladders[i].name + "=" + scene.ladders[i].rungs[rungs[i]]);
    return text;
}

}  // namespace snell::accuracy
