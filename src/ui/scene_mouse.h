// The mouse and the keys over the scene.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// Left drag rotates; wheel, middle drag or Ctrl-drag scales; right drag or Shift-drag moves along the screen; R or
// Home puts all back. Only while no panel has the mouse or the keys.
void hold_scene(const Facts& facts, const Rect& scene, View& view);

}  // namespace snell::ui
