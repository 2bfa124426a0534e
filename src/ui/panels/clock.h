// Controls of the scene's time: play, pause, step, scrub and speed.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the section, for animated scenes only.
void clock_panel(const Facts& facts, Memory& memory, Layout& layout);
// Space plays or pauses.
void clock_keys(const Facts& facts, Memory& memory);

}  // namespace snell::ui
