// Plots one ladder: error over time, both logarithmic.
#pragma once

#include <string>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// Returns an <svg> element of 640 by 400, whose parts have classes. `style` is included in it, for use as a file of its
// own.
std::string plot_svg(const SweepResult& sweep, std::string_view style = {});

}  // namespace snell::accuracy
