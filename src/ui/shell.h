// The layout of the whole window: the scene's area, the panel next to it, the status line below, and what is drawn over
// the picture.
#pragma once

#include "src/ui/kit/style.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the window; call it between Gui::begin and Gui::end. Stores the scene's area in `memory`.
Requests shell(const Facts& facts, Controls& controls, View& view, Memory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
