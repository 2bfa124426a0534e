// The files in use, each a link that opens it in the editor, and the appearance of the window.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

void files_section(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

// Draws the settings for theme and text size.
void look_section(Memory& memory, Layout& layout);

// Handles Ctrl+O, and Ctrl with +, - and 0.
void files_keys(Memory& memory, Requests& requests);

// Returns the next larger (`way` = 1) or smaller (`way` = -1) text size.
float next_zoom(float zoom, int way);

// Makes the last item a link with a tooltip. Returns true if it was clicked.
bool edit_link(const Facts& facts, const Place& place);

}  // namespace snell::ui
