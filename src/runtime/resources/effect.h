// Which sliders change nothing that a program computes, by the code that the driver makes of it.
#pragma once

#include <string_view>
#include <vector>

#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/program.h"

namespace snell::runtime {

// The values of a slider by which its effect is judged, both ends first. Numbers and truth values: all of them.
// Floats: eighths of the range, all numbers that `text` names in it, and the middles between these, so that a
// comparison with such a number is tried on both sides and at the number itself. Empty: more than 64 would be needed.
std::vector<double> telling_values(const Control& slider, std::string_view text);

// The time that a search may take.
struct Patience {
    double seconds;
    Stopwatch watch = {};
    bool ended() const { return watch.milliseconds() > 1000 * seconds; }
};

// Returns those of the sliders for which the driver makes the same code, whichever of these values is a constant in the
// place of the uniform. Sliders that the translator knows to have an effect are not tried, nor is anything once the
// patience has ended. Empty as well if the driver does not give its code, or gives it in a form that tells nothing.
std::vector<const Control*> without_effect(const LinkRequest& request, std::vector<const Control*> sliders,
                                           const Patience& patience);

}  // namespace snell::runtime
