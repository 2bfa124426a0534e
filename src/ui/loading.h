// What is seen while a scene loads.
#pragma once

#include <string>

namespace snell::ui {

// A bar in the middle of the screen, `share` (0 to 1) of it filled, with a line of text above.
void loading(const std::string& text, double share);

}  // namespace snell::ui
