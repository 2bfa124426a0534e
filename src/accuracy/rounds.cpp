#include "src/accuracy/rounds.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "src/accuracy/front.h"

namespace snell::accuracy {

Rounds::Rounds(std::vector<Entrant> entrants, RoundOptions options)
    : entrants_(std::move(entrants)),
      options_(std::move(options)),
      frame_(entrants_.size()),
      times_(entrants_.size()),
      stride_(entrants_.size(), 1),
      random_(options_.seed) {}

bool Rounds::step() {
    if (warmed_ < entrants_.size()) return warm_next();
    if (!decided_) decide();
    return round_ < rounds_ && time_next();
}

bool Rounds::warm_next() {
    const std::size_t i = warmed_++;
    if (options_.over()) {
        warmed_ = entrants_.size();
        return true;
    }
    options_.report("warming up", static_cast<double>(i) / static_cast<double>(entrants_.size()));
    frame_[i] = entrants_[i].warm_up(options_.clock);
    return true;
}

// If there is time for as many rounds as a front needs, all take part in all of them. Otherwise, so many rounds are the
// aim, and entrants that would use more than their share of the time take part in every second, fourth or eighth:
// then those of any two have as many rounds in common as possible.
void Rounds::decide() {
    const double time = std::max(1e3 * options_.seconds_left(), 0.0);
    const auto most = static_cast<std::size_t>(options_.rounds);
    const std::size_t needed = std::min(std::max(rounds_for(frame_.size()), fewest_rounds), most);
    const double share = time / static_cast<double>(frame_.size() + 1);
    double whole = 0, strided = 0;  // milliseconds of a round
    for (std::size_t i = 0; i < frame_.size(); ++i) {
        if (!frame_[i]) continue;
        const double sample = *frame_[i] > 500 ? *frame_[i] : *frame_[i] + std::max(*frame_[i], options_.at_least);
        const double wanted = std::ceil(sample * static_cast<double>(needed) / std::max(share, 1e-3));
        // Ensures at least three rounds.
        const double last = std::max(std::floor(static_cast<double>(needed) / 3), 1.0);
        stride_[i] = std::min(std::bit_ceil(static_cast<std::size_t>(std::clamp(wanted, 1.0, last))),
                              std::bit_floor(static_cast<std::size_t>(last)));
        const double times = i == options_.base ? 2 : 1;
        whole += times * sample;
        strided += times * sample / static_cast<double>(stride_[i]);
    }
    if (whole * static_cast<double>(needed) <= time) {
        std::fill(stride_.begin(), stride_.end(), 1);
        strided = whole;
    }
    rounds_ = static_cast<std::size_t>(std::clamp(time / std::max(strided, 1e-3), 1.0, static_cast<double>(most)));
    decided_ = true;
}

void Rounds::begin_round() {
    const std::size_t again = entrants_.size(), base = options_.base;
    for (std::size_t i = 0; i < again; ++i)
        if (frame_[i] && round_ % stride_[i] == 0) order_.push_back(i);
    if (frame_[base] && round_ % stride_[base] == 0) order_.push_back(again);
    for (std::size_t i = order_.size(); i > 1; --i) std::swap(order_[i - 1], order_[random_() % i]);
    for (auto& times : times_) times.push_back({});
    again_.push_back(0);
}

bool Rounds::time_next() {
    if (order_.empty()) begin_round();
    if (!order_.empty()) {
        if (options_.stopped()) return false;
        options_.report("timing", static_cast<double>(round_) / static_cast<double>(rounds_));
        const std::size_t i = order_.back();
        order_.pop_back();
        take(i, entrants_[i == entrants_.size() ? options_.base : i].time(options_.at_least));
    }
    if (order_.empty()) ++round_;
    return true;
}

// An index behind the last entrant is the control.
void Rounds::take(std::size_t entrant, const Times& times) {
    if (entrant == entrants_.size())
        again_.back() = chosen(times, options_.clock);
    else
        times_[entrant].back() = times;
}

}  // namespace snell::accuracy
