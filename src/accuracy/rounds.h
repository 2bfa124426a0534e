// Times in interleaved rounds: in each, every entrant is timed once, in random order, and one of them twice.
#pragma once

#include <chrono>
#include <ctime>
#include <functional>
#include <optional>
#include <random>
#include <string_view>
#include <vector>

#include "src/accuracy/bench.h"

namespace snell::accuracy {

// Something whose frames are timed.
struct Entrant {
    std::function<std::optional<double>(ClockKind)> warm_up;  // as Bench::warm_up
    std::function<Times(double at_least)> time;               // as Bench::time
};

struct RoundOptions {
    ClockKind clock = ClockKind::wall;
    std::size_t base = 0;  // the entrant that is timed twice
    std::size_t kept = 0;  // the last one that is left out, besides `base`
    int rounds = 31;       // at most
    double at_least = 20;  // minimum milliseconds of a sample
    std::uint64_t seed = 1;
    std::function<double()> seconds_left;
    std::function<bool()> over;     // asked before each warm-up but that of `base` and `kept`
    std::function<bool()> stopped;  // asked before each sample, and each warm-up
    std::function<void(std::string_view doing, double done)> report;
};

// How many rounds are measured is decided before the first: rounds until the result pleases would favour chance.
// Expensive entrants take part in every n-th, so that none uses more than its share of the time. If there is no time
// for as many rounds as a front needs, the most expensive entrants are left out: fewer rungs, not fewer rounds.
class Rounds {
public:
    Rounds(std::vector<Entrant> entrants, RoundOptions options);

    // Warms up one entrant, or times one. False: all is done, or there is no time.
    bool step();
    // By entrant and round; zeros where it did not take part.
    const std::vector<std::vector<Times>>& times() const { return times_; }
    // The second times of the base; 0 where it did not take part.
    const std::vector<double>& again() const { return again_; }

private:
    bool warm_next();
    void begin_round();
    bool time_next();
    void decide();
    std::size_t taking_part() const;
    std::size_t needed() const;
    double sample(std::size_t entrant) const;
    double stride(double time);
    void take(std::size_t entrant, const Times& times);

    std::vector<Entrant> entrants_;
    RoundOptions options_;
    std::vector<std::optional<double>> frame_;  // milliseconds after warming up; nullopt: it does not take part
    std::vector<std::vector<Times>> times_;
    std::vector<double> again_;
    std::vector<std::size_t> order_;    // of those that this round has yet to time, from the back
    std::vector<std::size_t> to_warm_;  // from the back
    std::size_t round_ = 0, rounds_ = 0;
    std::vector<std::size_t> stride_;
    bool decided_ = false;
    std::mt19937_64 random_;
};

// Clocks in milliseconds, with an arbitrary origin.

// CPU time of this process, summed over all cores.
inline double cpu_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

inline double wall_milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace snell::accuracy
