#include "src/app/window/measure/rung_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"

namespace snell {

namespace {

constexpr int fewest_rounds = 7, most_rounds = 21;
constexpr int most_frames = 20;  // of a sample
constexpr double budget = 6000;  // milliseconds of all rounds, where the fewest are not dearer
constexpr double shortest = 4;   // milliseconds of a sample: quicker frames are drawn several times
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
    Job job;
    job.chosen = chosen[ladder];
    for (std::size_t i = 0; i < scene.ladders[ladder].rungs.size(); ++i) {
        job.rungs.push_back(chosen);
        job.rungs.back()[ladder] = i;
        job.names.push_back(scene.ladders[ladder].rungs[i]);
    }
    job.rungs.push_back(chosen);
    job.times.resize(job.rungs.size());
    job_ = std::move(job);
    remark_.clear();
}

void RungCosts::stop() { job_.reset(); }

double RungCosts::done() const {
    if (!job_) return 0;
    const double rung = static_cast<double>(job_->next) / static_cast<double>(job_->rungs.size());
    return job_->timing ? .3 + .7 * std::min(1., (job_->rounds + rung) / job_->wanted) : .3 * rung;
}

bool RungCosts::step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
                     const gl::Caps& caps) {
    if (!job_) return false;
    if (!job_->mean) job_->mean = std::make_unique<SampleMean>(reference.width, reference.height, caps.es);
    if (!job_->mean->valid()) {
        stop();
        return true;
    }
    return job_->timing ? time_step(runtime, frame, caps.software)
                        : error_step(runtime, frame, reference, samples, caps.software);
}

bool RungCosts::error_step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
                           bool cpu) {
    Job& job = *job_;
    Controls controls = frame.controls;
    controls.rungs = job.rungs[job.next];
    const Frame here{.time = frame.time, .view = frame.view, .controls = controls};
    if (job.mean->samples() == samples) job.mean->restart();
    job.mean->add(runtime, here, cpu);
    if (job.mean->samples() < samples) return false;
    job.errors.push_back(accuracy::compare(job.mean->picture(runtime), reference).light.rmse);
    if (++job.next == job.names.size()) {
        job.next = 0;
        job.timing = true;
    }
    return true;
}

// One sample of one rung. Each round begins with another one.
bool RungCosts::time_step(Runtime& runtime, const Frame& frame, bool cpu) {
    Job& job = *job_;
    const std::size_t count = job.rungs.size();
    const std::size_t which = (job.next + static_cast<std::size_t>(job.rounds)) % count;
    Controls controls = frame.controls;
    controls.rungs = job.rungs[which];
    const Frame here{.time = frame.time, .view = frame.view, .controls = controls};
    job.mean->restart();
    // Not counted: others drew meanwhile, and caches and cube maps are theirs.
    const double first = job.mean->add(runtime, here, cpu);
    const int frames = std::clamp(static_cast<int>(std::ceil(shortest / std::max(first, .01))), 1, most_frames);
    double sum = 0;
    for (int i = 0; i < frames; ++i) sum += job.mean->add(runtime, here, cpu);
    job.times[which].push_back(sum / frames);
    job.spent += first + sum;
    if (++job.next < count) return false;
    job.next = 0;
    if (++job.rounds == 1)
        job.wanted =
            std::clamp(static_cast<int>(budget / std::max(job.spent, 1.)),
                       std::max(fewest_rounds, static_cast<int>(accuracy::rounds_for(job.names.size()))), most_rounds);
    if (job.rounds == job.wanted) conclude();
    return true;
}

void RungCosts::conclude() {
    const Job job = std::move(*job_);
    job_.reset();
    const accuracy::Control control = accuracy::control(job.times[job.chosen], job.times.back());
    std::vector<accuracy::Point> points;
    for (std::size_t i = 0; i < job.errors.size(); ++i) points.push_back({job.errors[i], job.times[i]});
    const auto verdicts = accuracy::pareto_front(points, accuracy::costs_of(points, control.noise));
    for (std::size_t i = 0; i < points.size(); ++i) {
        Known& known = known_[job.rungs[i]];
        known = {points[i].error, points[i].times, shown(verdicts[i].standing), {}};
        if (verdicts[i].by < job.names.size()) known.by = job.names[verdicts[i].by];
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
