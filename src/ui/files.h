// The files in use, each a link to its editor; and what the window looks like.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

void files_section(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

// Theme and size of letters.
void look_section(Memory& memory, Layout& layout);

// Ctrl+O, and Ctrl with +, - and 0.
void files_keys(Memory& memory, Requests& requests);

// The next larger (`way` 1) or smaller (-1) size of letters.
float next_zoom(float zoom, int way);

// Hand and tooltip over the last item; true: clicked.
bool edit_link(const Facts& facts, const Place& place);

}  // namespace snell::ui
