#include "src/plan/values/animate.h"

#include <algorithm>
#include <cmath>

#include "src/plan/values/declared.h"
#include "src/plan/values/numbers.h"

namespace snell {

namespace {

constexpr double shortest = 1e-3;  // seconds

Track track_of(const Animated& motion, const Control& control) {
    return {control.min, control.max, control.type, motion.logarithmic};
}

// Rounds to five digits of `size`, so that a saved number is short.
double rounded(double value, double size) {
    const double scale = std::pow(10, 5 - std::ceil(std::log10(size)));
    const double result = std::round(value * scale) / scale;
    return std::isfinite(result) ? result : value;
}

}  // namespace

Animated animated_from(const Control& control, std::size_t component, double period, double time, bool logarithmic) {
    Animated motion{control.program, control.name, component, std::max(period, shortest), time, logarithmic};
    const double fraction = fraction_of(control.value[component], track_of(motion, control));
    motion.start = time - fraction * motion.period / 2;
    return motion;
}

void animate(Controls& controls, std::vector<Animated>& animated, double time) {
    std::erase_if(animated, [&](const Animated& motion) {
        const Control* control = controls.find(motion.program, motion.name);
        return !control || motion.component >= control->value.size();
    });
    for (const Animated& motion : animated) {
        Control* control = controls.find(motion.program, motion.name);
        const double cycles = (time - motion.start) / std::max(motion.period, shortest);
        const double fraction = 1 - std::abs(2 * (cycles - std::floor(cycles)) - 1);
        const double exact = exact_at(fraction, track_of(motion, *control));
        const bool relative = motion.logarithmic && control->min > 0;
        const double value = rounded(exact, relative ? exact : control->max - control->min);
        control->value[motion.component] = std::clamp(fit_to_type(value, control->type), control->min, control->max);
    }
}

void carry_motions(const std::vector<Index>& programs, std::vector<Animated>& animated) {
    for (Animated& motion : animated)
        motion.program = motion.program < programs.size() ? programs[motion.program] : none;
    std::erase_if(animated, [](const Animated& motion) { return motion.program == none; });
}

Controls at_rest(Controls controls, std::span<const Animated> animated) {
    for (const Animated& motion : animated)
        if (Control* control = controls.find(motion.program, motion.name);
            control && motion.component < std::min(control->value.size(), control->initial.size()))
            control->value[motion.component] = control->initial[motion.component];
    return controls;
}

void set_logarithmic(Animated& motion, const Control& control, bool logarithmic, double time) {
    if (motion.logarithmic == logarithmic || motion.component >= control.value.size()) return;
    const double cycles = (time - motion.start) / motion.period;
    const bool back = cycles - std::floor(cycles) > .5;
    motion = animated_from(control, motion.component, motion.period, time, logarithmic);
    if (back) motion.start = 2 * time - motion.start - motion.period;
}

void set_period(Animated& motion, double period, double time) {
    const double cycles = (time - motion.start) / motion.period;
    motion.period = std::clamp(period, shortest_period, longest_period);
    motion.start = time - cycles * motion.period;
}

void stop(std::vector<Animated>& animated, const Control& control, std::size_t component) {
    std::erase_if(animated, [&](const Animated& motion) { return motion.moves(control, component); });
}

void stop_all(std::vector<Animated>& animated, Index program) {
    std::erase_if(animated, [&](const Animated& motion) { return motion.program == program; });
}

}  // namespace snell
