// The transformations that the user holds, how the scene is projected, and what is behind it.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

void view_section(const Facts& facts, View& view, Memory& memory, Layout& layout);

// P: a click picks, or no longer does. Escape: nothing is picked; then a click picks nothing.
void view_keys(View& view, HoldMemory& hold);

}  // namespace snell::ui
