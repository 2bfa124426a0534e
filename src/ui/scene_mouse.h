// Mouse input over the scene.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Applies the mouse to the transformation that is held. A left drag turns; the wheel, a middle drag or Ctrl-drag
// scales; a right drag or Shift-drag moves along the screen; Shift-wheel or Ctrl-Shift-drag moves towards the viewer.
// While picking is on, a click without a drag requests the object there. Does nothing while a panel has the mouse.
void hold_scene(const Facts& facts, const Rect& scene, View& view, HoldMemory& hold, Requests& requests);

}  // namespace snell::ui
