#include "src/accuracy/timing.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/gl/present.h"

namespace snell::accuracy {

namespace {

constexpr double long_enough = 500;  // milliseconds: one frame is a sample

}  // namespace

std::string_view name(ClockKind clock) {
    constexpr std::array<std::string_view, 3> names{"process CPU time", "GPU timer query", "wall clock"};
    return names[static_cast<std::size_t>(clock)];
}

double chosen(const Times& times, ClockKind clock) {
    return clock == ClockKind::cpu ? times.cpu : clock == ClockKind::gpu ? times.gpu : times.wall;
}

FrameClock::FrameClock(bool software) : software_(software) {
    if (software) return;
    gl::TimerQuery query;
    if (query.available()) query_ = std::move(query);
}

Times FrameClock::of(const Draw& draw, int frames) const {
    gl::finish();
    if (query_) query_->begin();
    const double cpu = cpu_milliseconds(), wall = wall_milliseconds();
    for (int i = 0; i < frames; ++i) {
        draw();
        gl::finish();
    }
    Times times{cpu_milliseconds() - cpu, wall_milliseconds() - wall, 0};
    if (query_) times.gpu = query_->end();
    return {times.cpu / frames, times.wall / frames, times.gpu / frames};
}

Times FrameClock::sample(const Draw& draw, double at_least) const {
    const Times first = of(draw);
    if (first.wall > long_enough) return first;
    return of(draw, std::clamp(static_cast<int>(std::ceil(at_least / std::max(first.wall, .01))), 1, 100));
}

double FrameClock::sample_milliseconds(double frame, double at_least) {
    return frame > long_enough ? frame : frame + std::max(frame, at_least);
}

double FrameClock::warm_up(const Draw& draw, ClockKind clock) const {
    double last = 0;
    for (int i = 0; i < 5; ++i) {
        const double now = chosen(of(draw), clock);
        const bool steady = i > 0 && std::abs(now - last) < .2 * last;
        last = now;
        if (steady || now > 4 * long_enough) break;
    }
    return last;
}

ClockKind FrameClock::choose(const Draw& draw) {
    if (!query_) return plain();
    const Times heavy = of(draw, std::clamp(static_cast<int>(200 / std::max(of(draw).wall, .01)), 1, 1000));
    query_over_wall_ = heavy.wall > 0 ? heavy.gpu / heavy.wall : 0;
    return query_over_wall_ >= .8 && query_over_wall_ <= 1.2 ? ClockKind::gpu : ClockKind::wall;
}

Rounds::Rounds(std::vector<Entrant> entrants, RoundOptions options)
    : entrants_(std::move(entrants)),
      options_(std::move(options)),
      frame_(entrants_.size()),
      times_(entrants_.size() + 1),
      stride_(entrants_.size(), 1),
      random_(options_.seed) {
    for (std::size_t i = entrants_.size(); i-- > 0;)
        if (i != options_.base && i != options_.kept) to_warm_.push_back(i);
    if (options_.kept != options_.base) to_warm_.push_back(options_.kept);
    to_warm_.push_back(options_.base);
}

bool Rounds::step() {
    if (!to_warm_.empty()) return warm_next();
    if (!decided_) decide();
    return round_ < rounds_ && time_next();
}

bool Rounds::warm_next() {
    const std::size_t i = to_warm_.back();
    to_warm_.pop_back();
    const bool first = i == options_.base || i == options_.kept;
    // Warming up one more takes the time of those that there are rounds for.
    const auto full = [&] { return stride(1e3 * options_.seconds_left()) > 1e3 * options_.seconds_left(); };
    if (options_.stopped() || (!first && ((!options_.everyone && full()) || options_.over()))) {
        to_warm_.clear();
        return true;
    }
    options_.report("warming up", 1 - static_cast<double>(to_warm_.size() + 1) / static_cast<double>(entrants_.size()));
    frame_[i] = entrants_[i].warm_up(options_.clock);
    return true;
}

std::size_t Rounds::taking_part() const {
    return static_cast<std::size_t>(
        std::count_if(frame_.begin(), frame_.end(), [](const auto& frame) { return frame.has_value(); }));
}

std::size_t Rounds::needed() const {
    return std::min(std::max(rounds_for(taking_part()), fewest_rounds), static_cast<std::size_t>(options_.rounds));
}

double Rounds::sample(std::size_t i) const { return FrameClock::sample_milliseconds(*frame_[i], options_.at_least); }

// If there is time for as many rounds as a front needs, all take part in all of them. Otherwise, so many rounds are the
// aim, and entrants that would use more than their share of the time take part in every second, fourth or eighth:
// then those of any two have as many rounds in common as possible. Returns the milliseconds that these rounds take.
double Rounds::stride(double time) {
    const auto rounds = static_cast<double>(needed());
    const double share = time / static_cast<double>(taking_part() + 1);
    double whole = 0, strided = 0;  // milliseconds of a round
    for (std::size_t i = 0; i < frame_.size(); ++i) {
        if (!frame_[i]) continue;
        const double wanted = std::ceil(sample(i) * rounds / std::max(share, 1e-3));
        // Ensures at least three rounds.
        const double last = std::max(std::floor(rounds / 3), 1.0);
        stride_[i] = std::min(std::bit_ceil(static_cast<std::size_t>(std::clamp(wanted, 1.0, last))),
                              std::bit_floor(static_cast<std::size_t>(last)));
        const double times = i == options_.base && options_.control ? 2 : 1;
        whole += times * sample(i);
        strided += times * sample(i) / static_cast<double>(stride_[i]);
    }
    if (whole * rounds > time && taking_part() > 2 && !options_.everyone) return strided * rounds;
    std::fill(stride_.begin(), stride_.end(), 1);
    return whole * rounds;
}

void Rounds::decide() {
    const double time = std::max(1e3 * options_.seconds_left(), 0.0);
    double wanted = stride(time);
    for (; wanted > time && taking_part() > 2 && !options_.everyone; wanted = stride(time)) {
        std::size_t most = options_.base;
        for (std::size_t i = 0; i < frame_.size(); ++i)
            if (frame_[i] && i != options_.base && i != options_.kept &&
                (most == options_.base || *frame_[i] > *frame_[most]))
                most = i;
        frame_[most].reset();
    }
    // Two are timed in the rounds that they need, until it is stopped.
    const double rounds = static_cast<double>(needed()) * std::max(time / std::max(wanted, 1e-3), 1.0);
    rounds_ = static_cast<std::size_t>(std::clamp(rounds, 1.0, static_cast<double>(options_.rounds)));
    decided_ = true;
}

void Rounds::begin_round() {
    const std::size_t again = entrants_.size(), base = options_.base;
    for (std::size_t i = 0; i < again; ++i)
        if (frame_[i] && round_ % stride_[i] == 0) order_.push_back(i);
    if (options_.control && frame_[base] && round_ % stride_[base] == 0) order_.push_back(again);
    for (std::size_t i = order_.size(); i > 1; --i) std::swap(order_[i - 1], order_[random_() % i]);
    // If the time is up in the first round, others say nothing without it.
    if (const auto found = ranges::find(order_, base); round_ == 0 && found != order_.end())
        std::swap(*found, order_.back());
    for (auto& times : times_) times.push_back({});
}

bool Rounds::time_next() {
    if (order_.empty()) begin_round();
    if (!order_.empty()) {
        if (options_.stopped()) return false;
        options_.report("timing", static_cast<double>(round_) / static_cast<double>(rounds_));
        const std::size_t i = order_.back();
        order_.pop_back();
        times_[i].back() = entrants_[i == entrants_.size() ? options_.base : i].time(options_.at_least);
    }
    if (order_.empty()) ++round_;
    return true;
}

std::vector<double> by_clock(std::span<const Times> rounds, ClockKind clock) {
    std::vector<double> times;
    for (const Times& round : rounds) times.push_back(chosen(round, clock));
    return times;
}

}  // namespace snell::accuracy
