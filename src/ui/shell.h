// The window around the panels: the picture with what lies over it, the line below it, and the table of keys.
#pragma once

#include <span>
#include <string>

#include "src/ui/kit/kit.h"
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

// Shortens a label to that many columns: first the blanks before the value go, then the middle of the name; of a value
// that is longer, the end.
std::string cut_name(const std::string& label, std::size_t columns);

// The line below the picture.

// Draws the scene's file, the number of problems, the outcome of the last request or the keys, and the cost. Where the
// line is too short, the least important of them are shortened and then left out, one after the other.
void status_line(const Facts& facts, const Rect& status, Memory& memory, Layout& layout);

// The progress bar that is shown while a scene loads.

// Draws a bar in the middle of the screen, filled to `share` (0 to 1), with a line of text above it.
void loading(const std::string& text, double share);

// Says over the picture's area that the first picture of the scene is being drawn.
void first_picture(const Facts& facts, const Rect& scene, Layout& layout);

// The table of what the mouse and the keys do. F1 shows it, and docs/window.md lists the same.

struct KeyRow {
    const char *keys, *what;
    const char* group = nullptr;  // the heading above this row; null: as for the row before
};
std::span<const KeyRow> key_rows();

// Draws the table over the window. Returns true if the user closed it.
bool help_panel(Layout& layout);

}  // namespace snell::ui
