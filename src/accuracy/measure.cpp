#include "src/accuracy/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/timing.h"
#include "src/runtime/resources/counters.h"

namespace snell::accuracy {

namespace {

constexpr double too_far = 3;      // in degrees
constexpr double rounding = 1e-7;  // of sums of samples in 32-bit floats, as an RMSE

std::vector<Point> points_of(const SweepResult& result) {
    std::vector<Point> points;
    for (const RungResult& rung : result.rungs) {
        const std::vector<double>& times = rung.times(result.clock);
        points.push_back(
            {rung.drawn ? result.error(rung) : std::nan(""), taken(times).empty() ? std::vector<double>{} : times});
    }
    return points;
}

// If directions are far off, RMSE no longer ranks; angles do, if all rungs have directions.
void choose_metric(SweepResult& result) {
    const auto has_angles = [](const RungResult& rung) { return rung.degrees && rung.degrees->pixels > 0; };
    const bool all_known =
        ranges::all_of(result.rungs, [&](const RungResult& rung) { return !rung.drawn || has_angles(rung); });
    bool far = false;
    for (RungResult& rung : result.rungs) {
        const bool by_angle = has_angles(rung);
        rung.saturated = rung.drawn && (by_angle ? rung.degrees->mean > too_far : rung.own.unrelated);
        far = far || (by_angle && rung.saturated);
    }
    result.metric = all_known && far ? Metric::degrees : Metric::rmse;
}

// Of errors that mean nothing, only how many pixels are not finite is kept.
void forget_errors(RungResult& rung) {
    for (Error* error : {&rung.whole, &rung.own})
        *error = {.light = unknown_figures, .display = unknown_figures, .nonfinite = error->nonfinite};
    rung.alone = unknown_figures;
    rung.flip = std::nan("");
    rung.elsewhere.reset();
    rung.degrees.reset();
}

class Measurement {
public:
    Measurement(Bench& bench, const Sweep& sweep, const MeasureOptions& options) : bench_(bench), options_(options) {
        result_.sweep = sweep;
        for (const SweepRung& rung : sweep.rungs) result_.rungs.push_back({.name = rung.name, .steps = rung.steps});
        drawn_.resize(sweep.rungs.size());
    }

    SweepResult run() {
        pictures();
        if (options_.times && !spent()) rounds();
        conclude(result_, again_);
        return std::move(result_);
    }

private:
    // The reference, where it counts, and the last rung as the scene is drawn.
    struct Goal {
        const Reference* reference;
        Region own;
        std::optional<Picture> last, facing, elsewhere;  // a knob's last setting may be too expensive
    };
    // What else was drawn of a rung, until it is known where it counts.
    struct Drawn {
        std::vector<float> flip;
        std::optional<Picture> facing, elsewhere;
    };

    double left() const { return options_.seconds + given_ - 1e-3 * watch_.milliseconds(); }

    bool stopped() {
        if (!result_.interrupted && options_.stop && options_.stop()) result_.interrupted = true;
        return result_.interrupted;
    }

    // True if no further picture should be drawn: half of the time is for times.
    bool over() {
        if (left() <= (options_.times ? options_.seconds / 2 : 0)) result_.late = true;
        return stopped() || result_.late;
    }
    // True if not even the last rung and the current one should be drawn or timed.
    bool spent() {
        if (left() + options_.spare <= 0) result_.late = true;
        return stopped() || left() + options_.spare <= 0;
    }

    void say(std::string_view doing, double done, double seconds) {
        if (options_.report) options_.report({result_.sweep.name, doing, done, seconds});
    }

    // What the current rung is compared with if there is time for nothing else: the last one or the first; of a knob,
    // whose last setting may be too expensive, the next one. May be none of the rungs.
    std::size_t other() const {
        const Sweep& sweep = result_.sweep;
        if (sweep.kind == SweepKind::knob && sweep.current + 1 < sweep.reference) return sweep.current + 1;
        return sweep.reference != sweep.current ? sweep.reference : sweep.current == 0 ? 1 : 0;
    }
    const Variant& variant(std::size_t rung) const { return result_.sweep.rungs[rung].variant; }

    // The pixels of the reference that change when the draws of the varied ladders are left out; all if none is known.
    Region own_region(const Reference& reference) {
        std::vector<bool> hidden(bench_.scene().draws.size(), false);
        for (std::size_t ladder : result_.sweep.moved) {
            const std::vector<bool> own = bench_.draws_of(ladder);
            for (std::size_t i = 0; i < own.size(); ++i) hidden[i] = hidden[i] || own[i];
        }
        if (ranges::find(hidden, true) == hidden.end()) return {};
        const auto without =
            bench_.picture({variant(result_.sweep.reference).rungs, reference.knobs}, &hidden, options_.stop);
        if (!without) return {};
        return where_different(reference.picture, *without);
    }

    // Adds the pixels where a rung is unlike the last one, both at the scene's own knobs: there a rung draws what the
    // reference leaves out. Pixels are the same for all rungs, so that their errors compare.
    void widen(Goal& goal) {
        if (goal.own.empty()) return;
        const auto add = [&](const Picture& a, const Picture& b) {
            const Region more = where_different(a, b);
            for (std::size_t i = 0; i < more.size(); ++i) goal.own[i] |= more[i];
        };
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            if (result_.rungs[i].drawn && goal.last) add(result_.rungs[i].picture, *goal.last);
            if (drawn_[i].elsewhere) add(*drawn_[i].elsewhere, *goal.elsewhere);
        }
        result_.own_pixels = count(goal.own);
        if (result_.own_pixels == 0) result_.cannot_say = "the ladder's draws cover no pixel";
    }

    // True, and noted, if the time was up before anything could be said.
    bool given_up() {
        if (spent()) result_.cannot_say = result_.interrupted ? "it was interrupted" : "the time was up";
        return !result_.cannot_say.empty();
    }

    void pictures() {
        if (given_up()) return;
        say("reference", 0, 0);
        const std::size_t at = result_.sweep.reference;
        References of_sweep(options_.seconds / 4);
        References& references = options_.references ? *options_.references : of_sweep;
        Goal goal{.reference = &references.of(bench_, variant(at).rungs, options_.stop)};
        // References have a time of their own; only what goes beyond it is taken from the sweep's.
        given_ = std::min(1e-3 * watch_.milliseconds(), references.seconds());
        if (given_up()) return;
        const bool knob = result_.sweep.kind == SweepKind::knob;
        goal.last = bench_.picture(variant(at), nullptr, [&] { return knob ? spent() : stopped(); });
        if (given_up() || goal.reference->picture.rgba.empty() || (!goal.last && !knob)) return;
        goal.own = own_region(*goal.reference);
        if (!knob) goal.facing = bench_.directions(variant(at));
        if (const Rungs& other = result_.sweep.rungs[at].elsewhere; !other.empty())
            goal.elsewhere = bench_.picture({other, {}});
        if (goal.last)
            draw_rung(at, goal);  // the reference and the scene's own rung first: without them the others say little
        if (result_.sweep.current != at) draw_rung(result_.sweep.current, goal);
        if (other() != at && other() < result_.rungs.size()) draw_rung(other(), goal);
        for (std::size_t i = 0; i < result_.rungs.size() && !over(); ++i)
            if (!result_.rungs[i].drawn) draw_rung(i, goal);
        widen(goal);
        judge_reference(goal);
        for (std::size_t i = 0; i < result_.rungs.size(); ++i)
            if (result_.rungs[i].drawn) compare_rung(i, goal);
    }

    void judge_reference(const Goal& goal) {
        const Reference& reference = *goal.reference;
        result_.finest = reference.knobs;
        result_.reference = reference.picture;
        for (const Picture* picture : {&reference.picture, goal.last ? &*goal.last : nullptr})
            if (const NonFinite bad = picture ? non_finite(*picture, goal.own) : NonFinite{};
                bad.count > 0 && !result_.broken) {
                result_.broken = true;
                result_.cannot_say = "the reference is " + text_of(bad);
            }
        if (!result_.cannot_say.empty() || reference.half.rgba.empty()) return;
        result_.residual = std::max(compare(reference.half, reference.picture, goal.own).light.rmse, rounding);
        result_.whole_residual = std::max(compare(reference.half, reference.picture).light.rmse, rounding);
    }

    void draw_rung(std::size_t i, const Goal& goal) {
        say("pictures", static_cast<double>(i) / static_cast<double>(result_.rungs.size()), 0);
        const bool is_last = i == result_.sweep.reference;
        const bool wanted = is_last || i == result_.sweep.current || i == other();
        auto picture =
            is_last ? goal.last : bench_.picture(variant(i), nullptr, [&] { return wanted ? stopped() : over(); });
        if (!picture) return;
        result_.rungs[i].drawn = true;
        drawn_[i].flip = flip_map(*picture, goal.reference->picture);
        result_.rungs[i].picture = std::move(*picture);
        if (goal.elsewhere && !over()) drawn_[i].elsewhere = bench_.picture({result_.sweep.rungs[i].elsewhere, {}});
        if (goal.facing) drawn_[i].facing = bench_.directions(variant(i));
    }

    void compare_rung(std::size_t i, const Goal& goal) {
        RungResult& rung = result_.rungs[i];
        const Drawn& drawn = drawn_[i];
        const Picture& reference = goal.reference->picture;
        rung.whole = compare(rung.picture, reference);
        rung.own = compare(rung.picture, reference, goal.own);
        rung.alone = unknown_figures;
        if (goal.last) rung.alone = compare(rung.picture, *goal.last, goal.own).light;
        rung.flip = mean_of(drawn.flip, goal.own);
        if (drawn.elsewhere) rung.elsewhere = compare(*drawn.elsewhere, *goal.elsewhere, goal.own).light;
        if (drawn.facing) rung.degrees = compare_directions(*drawn.facing, *goal.facing, goal.own);
        if (!result_.cannot_say.empty()) forget_errors(rung);
    }

    void rounds() {
        const std::size_t base = result_.sweep.current;
        result_.clock = bench_.choose_clock(variant(base));
        std::vector<Entrant> entrants;
        for (std::size_t i = 0; i < result_.rungs.size(); ++i)
            entrants.push_back({[this, i](ClockKind clock) {
                                    return result_.rungs[i].drawn ? bench_.warm_up(variant(i), clock) : std::nullopt;
                                },
                                [this, i](double at_least) { return bench_.time(variant(i), at_least); }});
        Rounds rounds(std::move(entrants),
                      {.clock = result_.clock,
                       .base = base,
                       .kept = other() < result_.rungs.size() ? other() : base,
                       .rounds = options_.rounds,
                       .at_least = options_.at_least,
                       .seed = options_.seed,
                       .seconds_left = [this] { return left(); },
                       .over = [this] { return left() <= 0; },
                       .stopped = [this] { return spent(); },
                       .report = [this](std::string_view doing, double done) { say(doing, done, left()); }});
        rounds.run();
        for (std::size_t i = 0; i < result_.rungs.size(); ++i) take_times(result_.rungs[i], rounds.times(i));
        again_ = by_clock(rounds.again(), result_.clock);
    }

    Bench& bench_;
    const MeasureOptions& options_;
    SweepResult result_;
    std::vector<Drawn> drawn_;  // by rung
    std::vector<double> again_;
    runtime::Stopwatch watch_;
    double given_ = 0;  // seconds besides those of the options
};

// Counts that end before they converge leave an error that finer knobs don't show. If the last steps shrink like a
// geometric series, it is the series' remainder; otherwise it is unknown.
void extrapolate(SweepResult& result) {
    const std::size_t n = result.rungs.size();
    if (result.sweep.kind != SweepKind::ladder || !result.sweep.numeric || n < 3 || !result.residual) return;
    if (!result.rungs[n - 2].drawn || !result.rungs[n - 3].drawn) return result.residual.reset();
    const double last = result.rungs[n - 2].alone.rmse, before = result.rungs[n - 3].alone.rmse;
    if (last == 0) return;
    const double shrinks = last / before;
    if (!(shrinks < .7)) {
        result.residual.reset();
        result.reference_note = "not converged: the errors of the last rungs before it do not decrease";
        return;
    }
    result.residual = std::max(*result.residual, last * shrinks / (1 - shrinks));
}

void judge_residual(SweepResult& result) {
    result.reference_note.clear();
    extrapolate(result);
    const int grid = result.finest.grid;
    const std::string knobs = fmt::format(
        "{0} x {0} samples a pixel{1}", grid,
        result.finest.plan.tessellation > 1 ? fmt::format(", tessellation x{}", result.finest.plan.tessellation) : "");
    if (!result.cannot_say.empty())
        result.reference_note = result.cannot_say;
    else if (result.sweep.kind == SweepKind::found)
        result.reference_note = "compared with the scene as it is, at the place where the difference is largest";
    else if (result.residual)
        result.reference_note =
            *result.residual > 0
                ? fmt::format("reference good to {:.0f} dB ({})", decibels(psnr(*result.residual), 0), knobs)
                : fmt::format("the reference does not change with finer knobs ({})", knobs);
    else if (result.reference_note.empty())
        result.reference_note = fmt::format("it is not known how good the reference is ({}): the time was up", knobs);
    // Elsewhere the rungs don't differ, so what was extrapolated is spread over more pixels.
    const double pixels = static_cast<double>(result.reference.pixels());
    const double share = result.own_pixels > 0 && pixels > 0 ? static_cast<double>(result.own_pixels) / pixels : 1;
    if (!result.residual) result.whole_residual.reset();
    if (result.whole_residual)
        result.whole_residual = std::max(*result.whole_residual, *result.residual * std::sqrt(share));
    for (RungResult& rung : result.rungs)
        rung.below_residual = rung.drawn && result.residual && rung.own.light.rmse <= *result.residual;
}

void conclude_times(SweepResult& result, std::span<const double> base_again) {
    const std::vector<double>& base = result.rungs[result.sweep.current].times(result.clock);
    result.control = control(base, base_again);
    for (RungResult& rung : result.rungs) {
        const std::vector<double>& times = rung.times(result.clock);
        const std::vector<double> present = taken(times);
        rung.rounds = present.size();
        if (!present.empty()) {
            const Interval interval = median_interval(present);
            rung.milliseconds = interval.middle;
            rung.low = interval.low;
            rung.high = interval.high;
        }
        rung.ratio = paired_ratio(times, base);
    }
    const std::vector<Point> points = points_of(result);
    const auto timed = ranges::count_if(result.rungs, [](const RungResult& rung) { return rung.rounds > 0; });
    // The budget may have ended within a round: then some that take part in every round have one less.
    std::size_t rounds = result.rungs[result.sweep.current].rounds;
    for (const RungResult& rung : result.rungs)
        if (rung.rounds > 0 && rung.rounds + 1 == result.rungs[result.sweep.current].rounds) rounds = rung.rounds;
    result.few_rounds = rounds < std::max(fewest_rounds, rounds_for(static_cast<std::size_t>(timed)));
    result.costs = costs_of(points, result.control.noise);
    const std::vector<Verdict> verdicts = pareto_front(points, result.costs);
    const bool row = result.sweep.kind != SweepKind::lattice && result.sweep.kind != SweepKind::found;
    const std::vector<bool> cliff = row ? cliffs(points.size(), result.costs) : std::vector<bool>(points.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
        result.rungs[i].verdict = verdicts[i];
        // A change without an error that saves nothing is none to make.
        const Cost cost = result.costs.of(i, result.sweep.current);
        if (result.sweep.kind == SweepKind::found && i != result.sweep.current &&
            verdicts[i].standing == Standing::front && cost != Cost::cheaper)
            result.rungs[i].verdict = {cost == Cost::equal ? Standing::saves_none : Standing::unsure,
                                       result.sweep.current};
        result.rungs[i].cliff = cliff[i] && result.trusted();
    }
}

}  // namespace

bool RungResult::hidden() const {
    constexpr double visible = 1 / 255.0, next_to_nothing = .02;
    if (!drawn || !elsewhere) return false;
    const auto [less, more] = std::minmax(alone.rmse, elsewhere->rmse);
    return more > visible && less < next_to_nothing * more;
}

void take_times(RungResult& rung, std::span<const Times> rounds) {
    rung.cpu = by_clock(rounds, ClockKind::cpu);
    rung.wall = by_clock(rounds, ClockKind::wall);
    rung.gpu = by_clock(rounds, ClockKind::gpu);
}

bool SweepResult::timed() const {
    return ranges::any_of(rungs, [](const RungResult& rung) { return rung.rounds > 0; });
}

double SweepResult::error(const RungResult& rung) const {
    const double rmse = rung.own.light.rmse;
    if (!std::isfinite(rmse)) return rmse;  // whatever its directions are
    if (metric == Metric::degrees && rung.degrees) return rung.degrees->mean;
    return std::max(rmse, residual.value_or(0));
}

void conclude(SweepResult& result, std::span<const double> base_again) {
    choose_metric(result);
    judge_residual(result);
    conclude_times(result, base_again);
}

SweepResult measure(Bench& bench, const Sweep& sweep, const MeasureOptions& options) {
    return Measurement(bench, sweep, options).run();
}

}  // namespace snell::accuracy
