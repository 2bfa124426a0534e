// The values over the picture, for screen shots.
#pragma once

#include "src/ui/state.h"
#include "src/ui/style.h"
#include "src/ui/text.h"

namespace snell::ui {

// A line for each slider, check box and colour, in the order of the Program lines, at the lower left of `scene`.
void value_labels(const Facts& facts, const Controls& controls, const Rect& scene, const Fonts& fonts);

// "Glass : uEta =     1.1000", as glman writes it.
Text label_of(const Scene& scene, const Control& control);

// Of a label with more columns than these: the name gives way, not the value.
std::string cut_name(const std::string& label, std::size_t columns);

}  // namespace snell::ui
