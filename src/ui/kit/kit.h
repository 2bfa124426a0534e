// The state that the widgets of one Dear ImGui context keep from frame to frame: the keyboard's focus, the number that
// is being typed, and the tooltip.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/platform/window.h"
#include "src/ui/kit/style.h"

namespace snell::ui {

// Rectangles of the window's items, in window coordinates from the top left.

struct Rect {
    float x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rect&) const = default;
    bool contains(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

// A widget of one frame, by name ("Glass.uEta", "axes"), so that a test can put the mouse on it.
struct Placed {
    std::string name;
    Rect rect;
    bool visible = false;  // not scrolled out of view
};

class Layout {
public:
    // Names are recorded only if `listening` is true, so that nothing is allocated otherwise.
    explicit Layout(bool listening) : listening_(listening) {}
    void clear() { items_.clear(); }
    // Records Dear ImGui's last item under this name.
    void note(std::string_view name);
    void note(std::string_view first, std::string_view second);
    // Records the window of Dear ImGui that is being drawn.
    void place_window(std::string_view name);
    // Records a rectangle that is not an item of Dear ImGui.
    void place(std::string_view name, const Rect& rect);
    const std::vector<Placed>& items() const { return items_; }

private:
    bool listening_;
    std::vector<Placed> items_;
};

// The widget that the keyboard acts on. Tab goes through the widgets in the order in which they are drawn: from the
// field of a value, and where nothing has the focus, to values only, and from there, and in dialogs, to all.
struct Focus {
    enum class Kind : std::uint8_t { value, text, button };  // a button is also a row, a drop-down, a check box
    struct Stop {
        unsigned id = 0;
        Kind kind = Kind::value;
        bool menu = false;  // an entry of a menu: arrow keys lead to the next one
    };
    unsigned at = 0;          // id of the widget; 0 if there is none
    Rect box;                 // of the widget, where it was drawn last
    bool tabbed = false;      // Tab moved it here, so the widget is scrolled into view
    bool opens = false;       // the widget opens its field
    bool presses = false;     // Enter and the space bar press the widget, and do nothing else
    bool refused = false;     // the field holds no number, so Tab stays
    bool taken = false;       // a widget took the focus in this frame
    bool passed = false;      // the widget with the focus was drawn in this frame
    std::vector<Stop> stops;  // of this frame
};

// The text of the number that is being typed. It is applied when the user enters it, not before.
struct Typing {
    unsigned id = 0;  // of the widget; 0 if nothing is being typed
    std::array<char, 128> text{};
    bool fresh = false;     // the field opens in this frame
    bool selected = false;  // the field opens with its text selected
    bool drawn = false;     // in this frame
    // A field that was pressed while this one is typed in, and its value: it opens once this one has taken its number.
    unsigned next = 0;
    double next_value = 0;
};

// A text next to an item.
struct Tip {
    Rect item, window;  // the item, and the window that it lies in
    std::string text;
    double since = 0;  // when the pointer came to rest on the item, by ImGui::GetTime()
    bool shown = false;
    bool quiet = false;  // the item was pressed, so nothing needs to be said until the pointer leaves it
};

// A number when a gesture began that may be taken back, and the scene's number then.
struct Before {
    double value = 0, initial = 0;
    // What to take it back to; a file that was saved with another number during the gesture has the last word.
    double restored(double scene) const { return scene == initial ? value : scene; }
};

// A number that is being dragged.
struct Drag {
    unsigned id = 0;  // of the widget; 0 if there is none
    Before before;
    double exact = 0;  // before rounding
};

// The last press of a button.
struct ClickMemory {
    MouseButton button = MouseButton::left;
    double since = -1e9, until = -1e9;  // when it happened at the earliest and at the latest
};

struct Kit {
    const Palette* palette = &palette_of(Theme::light);
    Focus focus;
    Typing typing;
    Tip tip;                      // what the pointer rests on
    Tip next_tip;                 // the same in this frame
    Tip remark;                   // why a typed text was not applied; shown until the next press
    Rect opener;                  // the button that opened the drop-down, menu or picker
    unsigned opened_by = 0;       // the widget that had the focus then, and gets it back; 0 if there was none
    bool opened_by_keys = false;  // Focus::presses of then
    bool swallows = false;        // a press that closes it does nothing else
    Drag drag;
    ClickMemory click;
    double late = 0;  // seconds that the last press of a key or button may have waited until it was seen
};

// Of the current context, which a Gui must have made.
Kit& kit();

// Call before and after the widgets of a frame; the first one before Dear ImGui's frame begins.
void begin_kit();
void end_kit();
// Tells in every frame whether what the button in this box opens is open. A press on the button closes it, and must not
// open it again. With `swallows`, a press beside what is open closes it and does nothing else.
void note_opener(const Rect& box, bool open, bool swallows = false);
// Seconds until the tooltip is due; infinite if none is.
double tip_due();

}  // namespace snell::ui
