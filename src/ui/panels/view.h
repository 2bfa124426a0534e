// The view section: the transformations that the user changes, the projection, and the background.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

void view_section(const Facts& facts, View& view, Memory& memory, Layout& layout);

// Handles the keys of the view: P turns picking on or off. Escape deselects the picked object or, if there is none,
// turns picking off.
void view_keys(View& view, HoldMemory& hold);

}  // namespace snell::ui
