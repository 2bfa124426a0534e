#include "src/accuracy/frame_clock.h"

#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace snell::accuracy
