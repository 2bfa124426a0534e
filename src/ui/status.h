// The line below the picture.
#pragma once

#include <string>

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the scene's file, the number of problems, the outcome of the last request or the keys, and the cost. Where the
// line is too short, the least important of them are shortened and then left out, one after the other.
void status_line(const Facts& facts, const Rect& status, Memory& memory, Layout& layout);

// The progress bar that is shown while a scene loads.

// Draws a bar in the middle of the screen, filled to `share` (0 to 1), with a line of text above it.
void loading(const std::string& text, double share);

// Says over the picture's area that the first picture of the scene is being drawn.
void first_picture(const Facts& facts, const Rect& scene, Layout& layout);

}  // namespace snell::ui
