// The controls of a scene: its ladders and the uniforms of its programs.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws a drop-down for each ladder.
void ladders_panel(const Facts& facts, Controls& controls, Layout& layout);

// Draws a section for each Program, with its uniforms as sliders, check boxes and colours.
void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout);

}  // namespace snell::ui
