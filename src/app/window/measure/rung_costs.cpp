#include "src/app/window/measure/rung_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"
#include "src/accuracy/rounds.h"
#include "src/runtime/resources/counters.h"

namespace snell {

namespace {

constexpr int most_rounds = 21;
constexpr double budget = 6;                        // seconds of all rounds, where the fewest are not dearer
constexpr double shortest = 4;                      // milliseconds of a sample: quicker frames are drawn several times
constexpr double errors_part = .3, warm_part = .1;  // of the progress
constexpr std::size_t most_rung_times = 15;

using Standing = ui::AccuracyPoint::Standing;

Standing shown(accuracy::Standing standing) {
    switch (standing) {
        case accuracy::Standing::front:
            return Standing::front;
        case accuracy::Standing::dominated:
            return Standing::dominated;
        case accuracy::Standing::saves_none:
            return Standing::saves_none;
        case accuracy::Standing::unsure:
            return Standing::unsure;
        case accuracy::Standing::unknown:
            break;
    }
    return Standing::visited;
}

// "exact", or all rungs that differ from the chosen ones: "exact, box".
std::string name_of(const Scene& scene, const Rungs& rungs, std::size_t ladder, const Rungs& chosen) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < rungs.size(); ++i)
        if (i == ladder || rungs[i] != chosen[i]) names.emplace_back(scene.ladders[i].rungs[rungs[i]]);
    return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace

struct RungCosts::Job {
    std::vector<std::string> names;  // of the ladder's rungs
    std::size_t chosen = 0;          // index into `names`
    std::vector<Rungs> rungs;        // in the order of `names`, and so are the errors
    std::vector<double> errors = {};
    std::optional<accuracy::SampleMean> mean = {};
    std::optional<accuracy::Rounds> rounds = {};
    double done = 0;
    double spent = 0;  // seconds of the steps of rounds
    // Of the present step.
    Runtime* runtime = nullptr;
    const Frame* frame = nullptr;

    Controls controls(std::size_t rung) const {
        Controls controls = frame->controls;
        controls.rungs = rungs[rung];
        return controls;
    }
};

RungCosts::RungCosts() = default;
RungCosts::~RungCosts() = default;

void RungCosts::forget() {
    known_.clear();
    job_.reset();
    remark_.clear();
}

void RungCosts::visit(const Rungs& rungs, double error, std::span<const double> times) {
    Known& known = known_[rungs];
    known.error = error;
    if (known.standing != Standing::visited) return;  // of rounds that others took part in: better
    known.times.assign(times.end() - static_cast<std::ptrdiff_t>(std::min(times.size(), most_rung_times)), times.end());
}

void RungCosts::begin(std::size_t ladder, const Scene& scene, const Rungs& chosen) {
    const std::vector<std::string>& names = scene.ladders[ladder].rungs;
    job_ = std::make_unique<Job>(
        Job{.names = names, .chosen = chosen[ladder], .rungs = std::vector<Rungs>(names.size(), chosen)});
    for (std::size_t i = 0; i < names.size(); ++i) job_->rungs[i][ladder] = i;
    remark_.clear();
}

void RungCosts::stop() { job_.reset(); }

double RungCosts::done() const { return job_ ? job_->done : 0; }

bool RungCosts::step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
                     const accuracy::FrameClock& clock, bool es) {
    if (!job_) return false;
    Job& job = *job_;
    if (!job.mean) job.mean.emplace(reference.width, reference.height, es);
    if (!job.mean->valid()) {
        stop();
        return true;
    }
    job.runtime = &runtime;
    job.frame = &frame;
    if (job.errors.size() < job.rungs.size()) return error_step(reference, samples, clock);
    if (!job.rounds) begin_rounds(clock);
    const runtime::Stopwatch watch;
    const double before = job.done;
    const bool more = job.rounds->step();
    job.spent += 1e-3 * watch.milliseconds();
    if (!more) conclude(clock.plain());
    return !more || job.done != before;
}

bool RungCosts::error_step(const accuracy::Picture& reference, int samples, const accuracy::FrameClock& clock) {
    Job& job = *job_;
    const Controls controls = job.controls(job.errors.size());
    if (job.mean->samples() == samples) job.mean->restart();
    job.mean->add(*job.runtime, {.time = job.frame->time, .view = job.frame->view, .controls = controls}, clock);
    if (job.mean->samples() < samples) return false;
    job.errors.push_back(accuracy::compare(job.mean->picture(*job.runtime), reference).light.rmse);
    job.done = errors_part * static_cast<double>(job.errors.size()) / static_cast<double>(job.rungs.size());
    return true;
}

void RungCosts::begin_rounds(const accuracy::FrameClock& clock) {
    Job& job = *job_;
    std::vector<accuracy::Entrant> entrants;
    for (std::size_t i = 0; i < job.rungs.size(); ++i) {
        const auto timed = [&job, i](const auto& by) {
            const Controls controls = job.controls(i);
            const Frame frame{.time = job.frame->time, .view = job.frame->view, .controls = controls};
            return by([&] { job.runtime->draw(frame, job.mean->surface()); });
        };
        entrants.push_back(
            {[=, &clock](accuracy::ClockKind kind) {
                 return std::optional(timed([&](const auto& draw) { return clock.warm_up(draw, kind); }));
             },
             [=, &clock](double least) { return timed([&](const auto& draw) { return clock.sample(draw, least); }); }});
    }
    job.rounds.emplace(std::move(entrants),
                       accuracy::RoundOptions{.clock = clock.plain(),
                                              .base = job.chosen,
                                              .kept = job.chosen,
                                              .everyone = true,
                                              .rounds = most_rounds,
                                              .at_least = shortest,
                                              .seconds_left = [&job] { return budget - job.spent; },
                                              .report =
                                                  [&job](std::string_view doing, double done) {
                                                      constexpr double warm = errors_part + warm_part;
                                                      job.done = doing == "timing" ? warm + (1 - warm) * done
                                                                                   : errors_part + warm_part * done;
                                                  }});
}

void RungCosts::conclude(accuracy::ClockKind clock) {
    const std::unique_ptr<Job> job = std::move(job_);
    const auto times = [&](const std::vector<accuracy::Times>& rounds) { return accuracy::by_clock(rounds, clock); };
    const accuracy::Control control =
        accuracy::control(times(job->rounds->times(job->chosen)), times(job->rounds->again()));
    std::vector<accuracy::Point> points;
    for (std::size_t i = 0; i < job->errors.size(); ++i)
        points.push_back({job->errors[i], times(job->rounds->times(i))});
    const auto verdicts = accuracy::pareto_front(points, accuracy::costs_of(points, control.noise));
    for (std::size_t i = 0; i < points.size(); ++i) {
        Known& known = known_[job->rungs[i]];
        known = {points[i].error, points[i].times, shown(verdicts[i].standing), {}};
        if (verdicts[i].by < job->names.size()) known.by = job->names[verdicts[i].by];
    }
    remark_ = accuracy::noise_sentence(control);
}

std::vector<ui::AccuracyPoint> RungCosts::points(const Scene& scene, std::size_t ladder, const Rungs& chosen) const {
    std::vector<ui::AccuracyPoint> points;
    for (const auto& [rungs, known] : known_) {
        if (rungs.size() != scene.ladders.size() || ladder >= rungs.size()) continue;
        ui::AccuracyPoint point;
        point.name = name_of(scene, rungs, ladder, chosen);
        Rungs others = rungs;
        others[ladder] = chosen[ladder];
        if (others == chosen) point.rung = rungs[ladder];
        point.chosen = rungs == chosen;
        point.reference = ranges::equal(
            rungs, scene.ladders, {}, [](std::size_t rung) { return rung + 1; },
            [](const Ladder& each) { return each.rungs.size(); });
        point.error = known.error;
        if (!known.times.empty()) {
            const accuracy::Interval interval = accuracy::median_interval(known.times);
            point.milliseconds = interval.middle;
            point.low = interval.low;
            point.high = interval.high;
        }
        point.standing = known.standing;
        point.by = known.by;
        points.push_back(std::move(point));
    }
    return points;
}

}  // namespace snell
