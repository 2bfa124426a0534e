// The rows of buttons at the top of the panel.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the two rows at the top of the panel: the menus of what is opened, saved and shown, and the snapshots.
void toolbar(const Facts& facts, View& view, Memory& memory, Requests& requests, Layout& layout);
// Ctrl+S saves the values to the scene, Ctrl+Shift+S as another scene; 1 to 9 restore a snapshot, Ctrl with 1 to 9
// stores it.
void keep_keys(const Facts& facts, Requests& requests);

// Hides or shows all but the picture. While it is hidden, a hint says for a moment how to show it.
void hide(Memory& memory);

}  // namespace snell::ui
