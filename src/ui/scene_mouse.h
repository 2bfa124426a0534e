// The mouse over the scene.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// Left drag turns; wheel, middle drag or Ctrl-drag scales; right drag or Shift-drag moves along the screen; Shift-wheel
// or Ctrl-Shift-drag towards the viewer: what is held. While a click picks, one that is no drag asks for the object
// there. Only while no panel has the mouse.
void hold_scene(const Facts& facts, const Rect& scene, View& view, const HoldMemory& hold, Requests& requests);

}  // namespace snell::ui
