// Keeps values: in the scene's text, in snapshots, or as a command in the clipboard.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the two rows of buttons.
void keep_panel(const Facts& facts, Requests& requests, Layout& layout);

// Handles Ctrl+S, which saves the values to the scene, and Ctrl+Shift+S, which undoes that; 1 to 9 restore a snapshot,
// Ctrl with 1 to 9 stores it.
void keep_keys(const Facts& facts, Requests& requests);

}  // namespace snell::ui
