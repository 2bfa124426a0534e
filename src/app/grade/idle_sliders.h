// Sliders that change nothing, found by the driver's code of the programs.
#pragma once

#include "src/document/document.h"

namespace snell::app {

// Adds a warning for each such slider of a scene without errors; takes about so many seconds.
void add_idle_sliders(Document& document, double seconds);

}  // namespace snell::app
