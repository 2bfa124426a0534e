// What a picture that shows nothing of its scene should say.
#pragma once

#include "src/document/document.h"

namespace snell::app {

// A warning for a frame of which no fragment reached the picture, with the option of --view that shows something, if
// one is found: it is drawn, small, to see whether it does. Leaves what the scene renders to as it is.
Diagnostics nothing_in_view(Document& document, const Frame& frame, int width, int height);

}  // namespace snell::app
