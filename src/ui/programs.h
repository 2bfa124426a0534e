// The controls of a scene.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// A drop-down for each ladder.
void ladders_panel(const Facts& facts, Controls& controls, Layout& layout);

// A section for each Program: its uniforms as sliders, check boxes and colours.
void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout);

}  // namespace snell::ui
