// Widgets that Dear ImGui lacks. They fill the width that is available.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include <imgui.h>

#include "src/plan/values/animate.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/text.h"

namespace snell::ui {

class Layout;
struct Rect;

float width_of(std::string_view text);
// The width of a button or a check box with this text.
float button_width(std::string_view label);
float check_box_width(std::string_view label);
// Sets the tooltip of the last item, disabled or not. It appears when the pointer has rested there for half a second,
// below the item or beside the panel, where it covers no neighbour; with `focused` without a pointer, too.
void tip(std::string_view text, bool focused = false);
// The same below the item's window, for items that stand above what is read with them.
void tip_below_window(std::string_view text);
// Adds the last item to the order of Tab, by an id of its own where it has none. Returns true if it was clicked, or the
// keys press it.
bool or_keys(bool clicked, unsigned id = 0);
// Begins the popup of this name below the last item, or above it, within the screen; its size is that of the last
// frame. Returns true if it is open; then call ImGui::EndPopup.
bool begin_popup(const char* name, bool above = false);
// Draws an entry of a menu, which a choice closes. Returns true if it was chosen.
bool menu_item(const char* text, const char* keys = nullptr, bool on = false, bool enabled = true);
// Draws a row that can be chosen. Returns true if it was clicked, or the keys press it.
bool selectable(const char* text, bool chosen = false, int flags = 0, const ImVec2& size = {0, 0});
// Draws a button and records its place as `name`. Returns true if the user pressed it.
bool button(const char* text, Layout& layout, std::string_view name);
// Likewise, placed by follow().
bool next_button(const char* text, Layout& layout, std::string_view name);
// The wheel over the last item scrolls nothing.
void keep_wheel();
// Draws text in front of the next item, which is placed on the same line.
void label(const char* text);
// The text with line breaks in place of blanks: Dear ImGui would also break at the point of a number.
std::string broken_at_blanks(std::string_view text, float width);
// Draws text that is wrapped at the right edge.
void wrapped(std::string_view text, bool dim = false);
// Places the next item, `width` wide, on the same line if it fits there, otherwise on the next line. `gap` is as for
// SameLine.
void follow(float width, float gap = -1);
// Moves the next item, `width` wide, to the right end of the line, where there is room.
void to_right(float width);
// Beside a panel of large letters the picture may be too narrow to read anything on it. Then the whole window's width
// is used, and the panel is shorter by what is above or below it.
bool has_room(const Rect& picture, float letters = 12);
Rect with_room(Rect picture);
// Cuts the middle out of a name so that it fits into the width, with dots for what is left out: names often differ only
// at their ends. Text with blanks is cut at its end. At least one character stays. Pass only visible text, without the
// hidden part after ##. With `at_end` names are cut there, too.
Text shortened(std::string_view text, float width, bool at_end = false);
// Draws such a text as an item whose tooltip has all of it. Returns false if something was left out.
bool fitted(std::string_view text, float width, bool dim = false);

// The titles of the open sections.
using Titles = std::set<std::string, std::less<>>;
// Draws a header that opens and closes its section, and returns whether it is open. `open` is saved from run to run.
// The tooltip says what the section is about.
bool section(const char* title, const char* about, Titles& open, Layout& layout, const char* name);

// Call after the header of a section: once the user opens it, show_opened() scrolls until its contents are visible.
void keep_in_view(bool open);
// Call where the contents of a section end: section() does, and the end of the scrolling area must.
void show_opened();

struct TabName {
    const char *title, *name;
};
// Draws the titles of two tabs. Returns the number of the chosen one, which is marked in the frame that it is pressed
// in: its contents follow, and at load the next frame may be late.
std::size_t tabs(const std::array<TabName, 2>& names, std::size_t chosen, Layout& layout);

struct SliderRange : Track {
    // Set by slider(): the user asked for the initial value; what the last press did was taken back.
    bool reset = false, taken_back = false;
};

// State of the slider that was pressed last. `before` is its value then, `stopped` the motion that the press ended:
// a double click, which moves the knob before it opens the text field, and Escape in a drag take both back.
struct SliderMemory {
    unsigned id = 0;
    Before before;
    bool relative = false;  // Shift or Alt was pressed: the drag continues relative to the knob's position
    bool dragged = false;   // it was no click
    double fraction = 0;    // position of that drag, before rounding
    std::optional<Animated> stopped;
    bool taken_back = false;  // by this slider, until it is asked for
};

// Draws a slider and returns true if the value changed. Drag to move; with Shift or Alt a twentieth as fast.
// Double-click or Ctrl-click to type; an entered number outside of the range widens it. Right-click to reset to
// `initial`. With the keyboard's focus the arrow keys move it by a hundredth of the range. With `number_width` the
// value is shown at the right, where a click edits it. It computes with fractions of the range in double, so any finite
// range works, including equal ends and 1e300.
bool slider(const char* id, double& value, SliderRange& range, double initial, SliderMemory& memory,
            float number_width = 0);

// What a field accepts. A drag ends there.
struct NumberLimits {
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();
};
// Draws a field to type a number into, or to drag, for numbers without a range. Right-click to reset to `initial`.
bool number(const char* id, double& value, ValueType type, double initial, float width,
            const NumberLimits& limits = {});
// Ends the typing of a number as a press beside its field does, if one is typed; returns whether.
bool leave_field();
// True in the press that left a field whose text was refused: a button that takes the number does nothing then.
bool refused();

// Draws a colour; `components` is 3 or 4: red, green, blue, alpha. Values outside of 0..1 are allowed. Picked colours
// are rounded to what a byte can tell apart; typed numbers are not.
bool color_row(const char* id, double* value, int components, const double* initial);

// Begins a drop-down as ImGui::BeginCombo does. A press on its button closes it again. With the keyboard's focus the
// arrow keys choose, open or not, and Enter and the space bar open and close it.
bool begin_combo(const char* id, const char* text, std::size_t& chosen, std::size_t count);
// Draws a header that opens and closes what is below it, and returns whether that is open.
bool header(const char* title, int flags = 0);
// Call after a tree node: the keys open and close it from the next frame on. Returns true if they did.
bool toggled_by_keys(bool open);
// Draws a check box, whose text is wrapped where the line is too short for it. Returns true if it was switched.
bool switch_box(const char* text, bool& on);

}  // namespace snell::ui
