// Sliders that move by themselves, back and forth over their ranges, as functions of time: the same time gives the same
// values, in the window and in saved pictures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/plan/values/controls.h"

namespace snell {

// The motion of one component of a control.
struct Animated {
    Index program = 0;
    std::string name;
    std::size_t component = 0;
    double period = 4;         // seconds from the minimum to the maximum and back
    double start = 0;          // a time at which the value is the minimum, in seconds
    bool logarithmic = false;  // equal times are equal ratios; needs a positive minimum

    bool moves(const Control& control, std::size_t which) const {
        return control.program == program && control.name == name && which == component;
    }
};

// Begins a motion at the control's current value, upwards.
Animated animated_from(const Control& control, std::size_t component, double period, double time,
                       bool logarithmic = false);
// Sets the values of this time. Motions whose control does not exist any more end.
void animate(Controls& controls, std::vector<Animated>& animated, double time);
// Carries motions to the programs of another text, in which carried_programs() found these. Those of others end.
void carry_motions(const std::vector<Index>& programs, std::vector<Animated>& animated);
inline constexpr double shortest_period = .1, longest_period = 1e4;  // seconds that may be set
// The value of this moment stays.
void set_period(Animated& motion, double period, double time);
void set_logarithmic(Animated& motion, const Control& control, bool logarithmic, double time);
// The controls with the scene's own values where they move: what a file would hold of a motion is the moment of saving.
Controls at_rest(Controls controls, std::span<const Animated> animated);
// stop() ends the motion of a component, stop_all() those of a program.
void stop(std::vector<Animated>& animated, const Control& control, std::size_t component);
void stop_all(std::vector<Animated>& animated, Index program);

}  // namespace snell
