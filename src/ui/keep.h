// Values to keep: in the scene, in snapshots, as a command.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// Two rows of buttons.
void keep_panel(const Facts& facts, Requests& requests, Layout& layout);

// Ctrl+S, and with Shift undoes it; 1 to 9 restore a snapshot, with Ctrl they store it.
void keep_keys(const Facts& facts, Requests& requests);

}  // namespace snell::ui
