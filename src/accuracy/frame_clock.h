// How long frames take. Whatever times frames does it here: the same waits, the same warming up, the same clock.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

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

}  // namespace snell::accuracy
