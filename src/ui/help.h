// What the mouse and the keys do. The one table of them: F1 shows it, and docs/window.md has the same.
#pragma once

#include <span>

#include "src/ui/layout.h"
#include "src/ui/style.h"

namespace snell::ui {

struct KeyRow {
    const char *keys, *what;
};
std::span<const KeyRow> key_rows();

// Over the scene while it is open; F1 and Escape close it.
void help_panel(const Rect& scene, bool& open, Layout& layout);

}  // namespace snell::ui
