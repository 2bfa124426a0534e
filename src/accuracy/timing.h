// How long frames take, alone and in interleaved rounds. Whatever times frames does it here: the same waits, the same
// warming up, the same clock.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "src/gl/target.h"

namespace snell::accuracy {

// The time of one frame, in milliseconds. `gpu` is 0 if there is no timer query, or its use is not allowed.
struct Times {
    double cpu = 0, wall = 0, gpu = 0;
};

// The clock whose times are used.
enum class ClockKind { cpu, gpu, wall };
// The name for reports, such as "wall clock".
std::string_view name(ClockKind clock);
// The time by that clock.
double chosen(const Times& times, ClockKind clock);

// Needs a current context. Frames are drawn by functions, and waited for one by one.
class FrameClock {
public:
    using Draw = std::function<void()>;

    // Without `software`, timer queries are made where the context has them.
    explicit FrameClock(bool software);

    // Draws so many frames. Returns the time per frame.
    Times of(const Draw& draw, int frames = 1) const;
    // Draws one frame that is not timed, as something else drew before and caches and cube maps are in its state; then
    // frames until `at_least` milliseconds have passed.
    Times sample(const Draw& draw, double at_least) const;
    // The milliseconds that this takes where a frame takes so many.
    static double sample_milliseconds(double frame, double at_least);
    // Draws until two consecutive frames differ by less than a fifth, at most five times. Returns the milliseconds of
    // the last one.
    double warm_up(const Draw& draw, ClockKind clock) const;

    // The clock that is right whatever is drawn: on software renderers the process's CPU time, otherwise wall time.
    ClockKind plain() const { return software_ ? ClockKind::cpu : ClockKind::wall; }
    // That clock, or timer queries if they agree with wall time within a fifth under a heavy load of such frames, which
    // must have been drawn before. query_over_wall() returns the measured ratio; 0 if it was not measured.
    ClockKind choose(const Draw& draw);
    double query_over_wall() const { return query_over_wall_; }

private:
    bool software_;
    std::optional<gl::TimerQuery> query_;
    double query_over_wall_ = 0;
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

// Times in interleaved rounds: in each, every entrant is timed once, in random order, and one of them twice.

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
