// The sections of the panel and the messages over the picture, one file each. Functions that end in _keys handle the
// keys of a section.
#pragma once

#include "src/ui/kit/style.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the controls of time: play, pause, step, scrub and speed. They are there for scenes that may depend on time,
// whatever the values are, and once a slider moved by itself, so that nothing below them moves under the mouse.
void clock_panel(const Facts& facts, Memory& memory, Layout& layout);
// Space plays or pauses.
void clock_keys(const Facts& facts, Memory& memory);

// Draws a drop-down for each ladder.
void ladders_panel(const Facts& facts, Controls& controls, Layout& layout);
// Draws a section for each Program, with its uniforms as sliders, check boxes and colours.
void programs_panel(const Facts& facts, Controls& controls, Memory& memory, Layout& layout);

// Draws the transformations that the user changes, and the background.
void view_section(const Facts& facts, View& view, Memory& memory, Layout& layout);
// Turns picking on or off; without picking, no object is picked.
void switch_picking(HoldMemory& hold);
// P turns picking on or off. Escape deselects the picked object or, if there is none, turns picking off.
void view_keys(View& view, HoldMemory& hold);

// Draws what the scene pays for and why, and what it does not pay for. Facts::explanation is needed only while
// Memory::costs is true.
void costs_section(const Facts& facts, Memory& memory, Layout& layout);
// Formats a size, such as "1.4 MB", in decimal units.
std::string bytes_text(std::uint64_t bytes);

// Draws Facts::frame_ms. Every panel with the time of the window's picture says it so.
void last_picture(const Facts& facts, Layout& layout);

// Draws the section; Memory::frame_cost says whether it is open. Returns true if the user starts measuring passes and
// draws, or stops it while it runs.
bool frame_cost_section(const Facts& facts, Memory& memory, Layout& layout);

// Draws the files in use, each a link that opens it in the editor.
void files_section(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);
// Makes the last item a link with a tooltip. Returns true if it was clicked.
// With `read_on`, what follows the item is read with it, and not covered.
bool edit_link(const Facts& facts, const Place& place, bool read_on = false);
// Draws the settings for theme and text size.
void look_section(Memory& memory, Layout& layout);
// True in a window in which nothing was opened yet.
inline bool no_scene_open(const Facts& facts) { return !facts.scene && facts.file.empty(); }
// Says, in an area without a scene, how to open one. Returns true if the user wants to choose one.
bool no_scene(const Rect& scene, Layout& layout);
bool no_scene_words(Layout& layout);  // the same within another window
// Returns the next larger (`way` = 1) or smaller (`way` = -1) text size.
float next_zoom(float zoom, int way);
// Ctrl+O opens the browser; Ctrl with +, - and 0 changes the text size.
void files_keys(Memory& memory, Requests& requests);

// Shows errors over the picture in full, because they must be seen. Warnings are one line until the user opens them.
// Returns where they end.
float problems_panel(const Facts& facts, const Rect& scene, const Fonts& fonts, Memory& memory, Requests& requests,
                     Layout& layout);
// Shows failures, and each message of a MessageBox statement, until the user dismisses them, in what is free of the
// picture. Returns where they begin.
float notices(const Facts& facts, const Rect& free, Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
