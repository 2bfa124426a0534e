// The table of what the mouse and the keys do. F1 shows it, and docs/window.md lists the same.
#pragma once

#include <span>

#include "src/ui/kit/kit.h"
#include "src/ui/kit/style.h"

namespace snell::ui {

struct KeyRow {
    const char *keys, *what;
    const char* group = nullptr;  // the heading above this row; null: as for the row before
};
std::span<const KeyRow> key_rows();

// Draws the table over the window. Returns true if the user closed it.
bool help_panel(Layout& layout);

}  // namespace snell::ui
