// The values of the controls as text over the picture, for screen shots.
#pragma once

#include "src/ui/kit/style.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws a line for each slider, check box and colour, in the order of the Program lines, at the lower left of `scene`.
void value_labels(const Facts& facts, const Controls& controls, const Rect& scene, const Fonts& fonts);

// Shortens a label to that many columns, by cutting the middle of the name and keeping the value.
std::string cut_name(const std::string& label, std::size_t columns);

}  // namespace snell::ui
