// All of the window: the scene's area, the panel beside it, the line below, and what lies over the picture.
#pragma once

#include "src/ui/state.h"
#include "src/ui/style.h"

namespace snell::ui {

// Between Gui::begin and Gui::end. Leaves the scene's area in `memory`.
Requests shell(const Facts& facts, Controls& controls, View& view, Memory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
