// A drop-down for each ladder, then one section for each Program: its uniforms as sliders, check boxes and colours.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout);

}  // namespace snell::ui
