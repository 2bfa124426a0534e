// The widgets that Dear ImGui lacks. All are as wide as there is room.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "src/ui/text.h"

namespace snell::ui {

class Layout;

float width_of(std::string_view text);
// Of a button with this text, or of a check box.
float button_width(std::string_view label);
float check_box_width(std::string_view label);
// Shown while the mouse is on the last item, disabled or not.
void tip(const char* text);
// The next item stands beside the last one if it has room there, else below. `gap` as for SameLine.
void follow(float width, float gap = -1);
// As much of the text as fits, with dots for the rest; at least one character. Only what is visible counts: what ##
// hides must not be in it.
Text shortened(std::string_view text, float width);
// The same as an item that tells all of it when the mouse is on it; false: something was left out.
bool fitted(std::string_view text, float width, bool dim = false);

// Titles of sections.
using Titles = std::set<std::string, std::less<>>;
// A header that opens and closes; `open` keeps which are open, from run to run.
bool section(const char* title, Titles& open, Layout& layout, const char* name);

struct SliderRange {
    double min = 0, max = 1;
    bool integral = false;
    bool logarithmic = false;  // equal ways are equal ratios; only where min > 0
};

// The slider that was pressed last, with the value it had: a double click first moves the knob, then types.
struct SliderMemory {
    unsigned id = 0;
    double before = 0;
    bool relative = false;  // Alt was down during this drag: it goes on from where it is
    double fraction = 0;    // of that drag, unrounded
};

// Drag: moves; with Alt a twentieth as fast. Double click or Ctrl-click: type; a number beyond the range widens it.
// Right click: `initial`. Works in fractions of the range, in double: any finite range will do, equal ends and 1e300
// included. True when the value changed.
bool slider(const char* id, double& value, SliderRange& range, double initial, SliderMemory& memory);

// A field to type a number into, or to drag for numbers without a range.
bool number(const char* id, double& value, bool integral, double initial, float width);

// `components` 3 or 4: red, green, blue, alpha. Outside 0..1 allowed.
bool color_row(const char* id, double* value, int components, const double* initial);

}  // namespace snell::ui
