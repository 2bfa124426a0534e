// One ladder as a picture: error over time, both logarithmic.
#pragma once

#include <string>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// An <svg> element, 640 by 400, whose parts have classes. `style`: stands in it, for a file of its own.
std::string plot_svg(const SweepResult& sweep, std::string_view style = {});

// For texts and attributes of HTML and SVG.
std::string escaped(std::string_view text);

}  // namespace snell::accuracy
