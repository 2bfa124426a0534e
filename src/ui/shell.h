
#pragma once

#include "src/ui/kit/style.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

// The scale of letters in a window of this width: the wanted one, or what leaves a third of the width for the picture.
float fitting_scale(float wanted, float width);

// Draws the window; call it between Gui::begin and Gui::end. Stores the scene's area in `memory`.
Requests shell(const Facts& facts, Controls& controls, View& view, Memory& memory, const Fonts& fonts, Layout& layout);

// Mouse input over the scene.

// Applies the mouse to the transformation that is held. A left drag turns; the wheel, a middle drag or Ctrl-drag
// scales; a right drag or Shift-drag moves along the screen; Shift-wheel or Ctrl-Shift-drag moves towards the viewer.
// While picking is on, a click without a drag requests the object there. Does nothing while a panel has the mouse.
void hold_scene(const Facts& facts, const Rect& scene, View& view, HoldMemory& hold, Requests& requests);

// Draws a line for each slider, check box and colour, in the order of the Program lines, at the lower left of `scene`.
void value_labels(const Facts& facts, const Controls& controls, const Rect& scene, const Fonts& fonts);

// Shortens a label to that many columns, by cutting the middle of the name and keeping the value.
std::string cut_name(const std::string& label, std::size_t columns);

}  // namespace snell::ui
