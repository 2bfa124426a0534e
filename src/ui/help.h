// The table of what the mouse and the keys do. F1 shows it, and docs/window.md lists the same.
#pragma once

#include <span>

#include "src/ui/kit/layout.h"
#include "src/ui/kit/style.h"

namespace snell::ui {

struct KeyRow {
    const char *keys, *what;
};
std::span<const KeyRow> key_rows();

// Draws the table over the scene. Returns true if the user closed it.
bool help_panel(const Rect& scene, Layout& layout);

}  // namespace snell::ui
