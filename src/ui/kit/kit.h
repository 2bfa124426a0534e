// The state that the widgets of one Dear ImGui context keep from frame to frame: the keyboard's focus, the number that
// is being typed, and the tooltip.
#pragma once

#include <array>
#include <string>

#include "src/ui/kit/layout.h"
#include "src/ui/kit/style.h"

namespace snell::ui {

// The value that the keyboard acts on. Tab goes through the values in the order in which they are drawn.
struct Focus {
    unsigned at = 0;                                      // id of the widget; 0 if there is none
    bool tabbed = false;                                  // Tab moved it here, so the widget is scrolled into view
    bool opens = false;                                   // the widget opens its field
    bool refused = false;                                 // the field holds no number, so Tab stays
    bool taken = false;                                   // a widget took the focus in this frame
    bool passed = false;                                  // the widget with the focus was drawn in this frame
    unsigned first = 0, last = 0, before = 0, after = 0;  // ids of this frame
};

// The text of the number that is being typed. It is applied when the user enters it, not before.
struct Typing {
    unsigned id = 0;  // of the widget; 0 if nothing is being typed
    std::array<char, 128> text{};
    bool fresh = false;     // the field opens in this frame
    bool selected = false;  // the field opens with its text selected
    bool drawn = false;     // in this frame
};

// A text next to an item.
struct Tip {
    Rect item, window;  // the item, and the window that it lies in
    std::string text;
    double since = 0;  // when the pointer came to rest on the item, by ImGui::GetTime()
    bool shown = false;
    bool quiet = false;  // the item was pressed, so nothing needs to be said until the pointer leaves it
};

struct Kit {
    const Palette* palette = &palette_of(Theme::light);
    Focus focus;
    Typing typing;
    Tip tip;             // what the pointer rests on
    Tip next_tip;        // the same in this frame
    Tip remark;          // why a typed text was not applied; shown until the next press
    Rect opener;         // the button that opened the drop-down, menu or picker
    double dragged = 0;  // the number that is being dragged, before rounding
};

// Of the current context, which a Gui must have made.
Kit& kit();

// Call before and after the widgets of a frame; the first one before Dear ImGui's frame begins.
void begin_kit();
void end_kit();
// Tells in every frame whether what the button in this box opens is open. A press on the button closes it, and must not
// open it again.
void note_opener(const Rect& box, bool open);
// Seconds until the tooltip is due; infinite if none is.
double tip_due();

}  // namespace snell::ui
