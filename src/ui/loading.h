// The progress bar that is shown while a scene loads.
#pragma once

#include <string>

namespace snell::ui {

// Draws a bar in the middle of the screen, filled to `share` (0 to 1), with a line of text above it.
void loading(const std::string& text, double share);

}  // namespace snell::ui
