// Play, pause, step, scrub and speed.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// A section, for scenes that move. Space plays and pauses.
void clock_panel(const Facts& facts, Memory& memory, Layout& layout);
void clock_keys(const Facts& facts, Memory& memory);

}  // namespace snell::ui
