#include "src/accuracy/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

namespace snell::accuracy {

namespace {

constexpr std::size_t fewest_rounds = 7;  // the minimum for an interval of the median
constexpr int most_rounds = 8;      // as a multiple of those requested; used if they are inconclusive and time is left
constexpr int looked_at_every = 5;  // in rounds
constexpr double too_far = 3;       // in degrees

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

const std::vector<double>& times_of(const RungResult& rung, ClockKind clock) {
    return clock == ClockKind::cpu ? rung.cpu : clock == ClockKind::gpu ? rung.gpu : rung.wall;
}

std::vector<double> taken(const std::vector<double>& times) {
    std::vector<double> result;
    std::ranges::copy_if(times, std::back_inserter(result), [](double t) { return t > 0; });
    return result;
}

std::vector<Point> points_of(const SweepResult& result) {
    std::vector<Point> points;
    for (const RungResult& rung : result.rungs) {
        const std::vector<double>& times = times_of(rung, result.clock);
        points.push_back(
            {rung.drawn ? result.error(rung) : std::nan(""), taken(times).empty() ? std::vector<double>{} : times});
    }
    return points;
}

// If directions are far off, RMSE no longer ranks; angles do, if all rungs have directions.
void choose_metric(SweepResult& result) {
    const bool all_known = std::ranges::all_of(
        result.rungs, [](const RungResult& rung) { return !rung.drawn || rung.degrees.has_value(); });
    bool far = false;
    for (RungResult& rung : result.rungs) {
        const bool by_angle = rung.degrees && rung.degrees->pixels > 0;
        rung.saturated = rung.drawn && (by_angle ? rung.degrees->mean > too_far : rung.own.unrelated);
        far = far || (by_angle && rung.saturated);
    }
    result.metric = all_known && far ? Metric::degrees : Metric::rmse;
}

class Measurement {
public:
    Measurement(Bench& bench, const Sweep& sweep, const MeasureOptions& options) : bench_(bench), options_(options) {
        result_.sweep = sweep;
        for (const SweepRung& rung : sweep.rungs) result_.rungs.push_back({.name = rung.name, .steps = rung.steps});
    }

    SweepResult run() {
        pictures();
        choose_metric(result_);
        if (options_.times && !stopped()) rounds();
        conclude(result_, again_, options_.seed);
        return std::move(result_);
    }

private:
    bool stopped() {
        if (!result_.interrupted && options_.stop && options_.stop()) result_.interrupted = true;
        return result_.interrupted;
    }

    void say(std::string_view doing, double done, double left) {
        if (options_.report) options_.report({result_.sweep.name, doing, done, left});
    }

    const Variant& variant(std::size_t rung) const { return result_.sweep.rungs[rung].variant; }

    // The pixels that change when the draws of the varied ladders are left out of the reference.
    Region own_region(const Picture& reference) {
        std::vector<bool> hidden(bench_.scene().draws.size(), false);
        for (std::size_t ladder : result_.sweep.moved) {
            const std::vector<bool> own = bench_.draws_of(ladder);
            for (std::size_t i = 0; i < own.size(); ++i) hidden[i] = hidden[i] || own[i];
        }
        if (std::ranges::find(hidden, true) == hidden.end()) return {};
        const auto without = bench_.picture(variant(result_.sweep.reference), &hidden);
        Region region = without ? where_different(reference, *without) : Region{};
        result_.own_pixels = count(region);
        return result_.own_pixels > 0 ? region : Region{};
    }

    void pictures() {
        say("reference", 0, 0);
        const std::size_t at = result_.sweep.reference;
        auto reference = bench_.picture(variant(at));
        if (!reference) return;
        const Region own = own_region(*reference);
        const bool ladders = result_.sweep.kind != SweepKind::knob;
        const auto facing = ladders ? bench_.directions(variant(at)) : std::nullopt;
        for (std::size_t i = 0; i < result_.rungs.size() && !stopped(); ++i) {
            RungResult& rung = result_.rungs[i];
            say("pictures", static_cast<double>(i) / static_cast<double>(result_.rungs.size()), 0);
            auto picture = i == at ? reference : bench_.picture(variant(i));
            if (!picture) continue;
            rung.drawn = true;
            rung.whole = compare(*picture, *reference);
            rung.own = own.empty() ? rung.whole : compare(*picture, *reference, own);
            if (i != at) rung.flip = mean_of(flip_map(*picture, *reference), own);
            rung.picture = std::move(*picture);
            if (!facing) continue;
            if (const auto directions = bench_.directions(variant(i)))
                rung.degrees = compare_directions(*directions, *facing, own);
        }
    }

    // In how many rounds each rung takes part (every n-th), so that none uses more than its share of the time.
    std::vector<std::size_t> strides(const std::vector<std::optional<double>>& frame) const {
        std::vector<std::size_t> result(frame.size(), 1);
        const double share = options_.seconds * 1e3 / static_cast<double>(frame.size() + 1);
        for (std::size_t i = 0; i < frame.size(); ++i) {
            if (!frame[i]) continue;
            const double sample = *frame[i] > 500 ? *frame[i] : *frame[i] + std::max(*frame[i], options_.at_least);
            const double all = sample * options_.rounds;
            // Ensures at least three rounds.
            const auto most = static_cast<std::size_t>(std::max(options_.rounds / 3, 1));
            if (all > share) result[i] = std::min(static_cast<std::size_t>(std::ceil(all / share)), most);
        }
        return result;
    }

    void rounds() {
        const std::size_t base = result_.sweep.current;
        result_.clock = bench_.choose_clock(variant(base));
        std::vector<std::optional<double>> frame(result_.rungs.size());
        for (std::size_t i = 0; i < frame.size() && !stopped(); ++i) {
            say("warming up", static_cast<double>(i) / static_cast<double>(frame.size()), options_.seconds);
            if (result_.rungs[i].drawn) frame[i] = bench_.warm_up(variant(i), result_.clock);
        }
        const std::vector<std::size_t> stride = strides(frame);
        const auto start = std::chrono::steady_clock::now();
        std::mt19937_64 random(options_.seed);
        const std::size_t again = frame.size();
        // One interval in twenty misses 1 by chance, and many are initially too wide, so more rounds are measured.
        for (int round = 0; round < most_rounds * options_.rounds; ++round) {
            const bool enough = round >= options_.rounds;
            if (enough && seconds_since(start) > options_.seconds) break;
            if (enough && (round - options_.rounds) % looked_at_every == 0 && !still_noisy() && !still_undecided())
                break;
            std::vector<std::size_t> order;
            for (std::size_t i = 0; i < frame.size(); ++i)
                if (frame[i] && static_cast<std::size_t>(round) % stride[i] == 0) order.push_back(i);
            if (frame[base] && static_cast<std::size_t>(round) % stride[base] == 0) order.push_back(again);
            for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
            for (RungResult& rung : result_.rungs)
                for (auto* times : {&rung.cpu, &rung.wall, &rung.gpu}) times->push_back(0);
            again_.push_back(0);
            for (std::size_t i : order) {
                const double spent = seconds_since(start);
                if (stopped() || (spent > 1.25 * options_.seconds && round >= 3)) return;
                say("timing", std::max(static_cast<double>(round) / options_.rounds, spent / options_.seconds),
                    std::max(options_.seconds - spent, 0.0));
                const Times times = bench_.time(variant(i == again ? base : i), options_.at_least);
                if (i == again) {
                    again_.back() = chosen(times, result_.clock);
                    continue;
                }
                result_.rungs[i].cpu.back() = times.cpu;
                result_.rungs[i].wall.back() = times.wall;
                result_.rungs[i].gpu.back() = times.gpu;
            }
        }
    }

    bool still_noisy() const {
        const RungResult& base = result_.rungs[result_.sweep.current];
        return control(times_of(base, result_.clock), again_, options_.seed).noisy;
    }

    bool still_undecided() const { return undecided(points_of(result_), options_.seed); }

    Bench& bench_;
    const MeasureOptions& options_;
    SweepResult result_;
    std::vector<double> again_;
};

// If the last steps shrink like a geometric series, the residual is its remainder; otherwise it is unknown.
void estimate_residual(SweepResult& result) {
    const std::size_t n = result.rungs.size();
    if (result.sweep.kind != SweepKind::ladder || !result.sweep.numeric || n < 3) {
        result.residual_note = result.sweep.kind == SweepKind::knob ? "the finest setting is assumed to be exact"
                                                                    : "the last rung is assumed to be exact";
        return;
    }
    const double last = result.rungs[n - 2].own.rmse, before = result.rungs[n - 3].own.rmse;
    const double shrinks = before > 0 ? last / before : 0;
    if (!(shrinks < .7)) {
        result.residual_note = "not converged: the errors of the last rungs before the reference do not decrease";
        return;
    }
    result.residual = last * shrinks / (1 - shrinks);
    result.residual_note = "extrapolated from the last steps towards the reference";
    for (std::size_t i = 0; i < n; ++i)
        result.rungs[i].below_residual = i != result.sweep.reference && result.rungs[i].own.rmse < 3 * *result.residual;
}

void conclude_times(SweepResult& result, std::span<const double> base_again, std::uint64_t seed) {
    const std::vector<double>& base = times_of(result.rungs[result.sweep.current], result.clock);
    result.control = control(base, base_again, seed);
    for (RungResult& rung : result.rungs) {
        const std::vector<double>& times = times_of(rung, result.clock);
        const std::vector<double> present = taken(times);
        rung.rounds = present.size();
        if (!present.empty()) {
            const Interval interval = bootstrap_median(present, seed);
            rung.milliseconds = interval.middle;
            rung.low = interval.low;
            rung.high = interval.high;
        }
        rung.ratio = paired_ratio(times, base, seed);
    }
    const std::vector<Point> points = points_of(result);
    result.few_rounds = result.rungs[result.sweep.current].rounds < fewest_rounds;
    const std::vector<Verdict> verdicts = pareto_front(points, seed);
    const bool row = result.sweep.kind != SweepKind::lattice;
    const std::vector<bool> dear = row ? cliffs(points, seed) : std::vector<bool>(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.rungs[i].verdict = verdicts[i];
        result.rungs[i].cliff = dear[i] && result.trusted();
    }
}

}  // namespace

double SweepResult::error(const RungResult& rung) const {
    return metric == Metric::degrees && rung.degrees ? rung.degrees->mean : rung.own.rmse;
}

void conclude(SweepResult& result, std::span<const double> base_again, std::uint64_t seed) {
    choose_metric(result);
    estimate_residual(result);
    conclude_times(result, base_again, seed);
}

SweepResult measure(Bench& bench, const Sweep& sweep, const MeasureOptions& options) {
    return Measurement(bench, sweep, options).run();
}

}  // namespace snell::accuracy
