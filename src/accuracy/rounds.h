// Times in interleaved rounds: in each, every entrant is timed once, in random order, and one of them twice.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "src/accuracy/frame_clock.h"

namespace snell::accuracy {

// Something whose frames are timed.
struct Entrant {
    std::function<std::optional<double>(ClockKind)> warm_up;  // as FrameClock::warm_up; nullopt: it can't be drawn
    std::function<Times(double at_least)> time;               // as FrameClock::sample
};

struct RoundOptions {
    ClockKind clock = ClockKind::wall;
    std::size_t base = 0;  // the entrant that is timed first, and, if `control`, twice in each round
    std::size_t kept = 0;  // the last one that is left out, besides `base`
    bool control = true;
    bool everyone = false;  // takes part in as many rounds as a front needs, however long these take
    int rounds = 31;        // at most
    double at_least = 20;   // minimum milliseconds of a sample
    std::uint64_t seed = 1;
    std::function<double()> seconds_left = [] { return std::numeric_limits<double>::infinity(); };
    std::function<bool()> over = [] { return false; };     // asked before each warm-up but that of `base` and `kept`
    std::function<bool()> stopped = [] { return false; };  // asked before each sample, and each warm-up
    std::function<void(std::string_view doing, double done)> report = [](std::string_view, double) {};
};

// How many rounds are measured is decided before the first: rounds until the result pleases would favour chance.
// Expensive entrants take part in every n-th, so that none uses more than its share of the time. If there is no time
// for as many rounds as a front needs, the most expensive entrants are left out: fewer rungs, not fewer rounds.
class Rounds {
public:
    Rounds(std::vector<Entrant> entrants, RoundOptions options);

    // Warms up one entrant, or times one. False: all is done, or there is no time.
    bool step();
    // All that is left.
    void run() {
        while (step()) continue;
    }
    // Of an entrant, by round; zeros where it did not take part.
    const std::vector<Times>& times(std::size_t entrant) const { return times_[entrant]; }
    // The second times of the base; zeros where it did not take part.
    const std::vector<Times>& again() const { return times_.back(); }

private:
    bool warm_next();
    void begin_round();
    bool time_next();
    void decide();
    std::size_t taking_part() const;
    std::size_t needed() const;
    double sample(std::size_t entrant) const;  // milliseconds
    double stride(double time);

    std::vector<Entrant> entrants_;
    RoundOptions options_;
    std::vector<std::optional<double>> frame_;  // milliseconds after warming up; nullopt: it does not take part
    std::vector<std::vector<Times>> times_;     // the control behind the entrants
    std::vector<std::size_t> order_;            // of those that this round has yet to time, from the back
    std::vector<std::size_t> to_warm_;          // from the back
    std::size_t round_ = 0, rounds_ = 0;
    std::vector<std::size_t> stride_;
    bool decided_ = false;
    std::mt19937_64 random_;
};

// By that clock; 0 where a round has none.
std::vector<double> by_clock(std::span<const Times> rounds, ClockKind clock);

}  // namespace snell::accuracy
