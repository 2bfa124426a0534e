// Writes the state of a window as JSON, for tests.
#pragma once

#include <string>

#include "src/app/window/display.h"
#include "src/app/window/workspace.h"
#include "src/platform/window.h"
#include "src/ui/kit/kit.h"
#include "src/ui/panels/state.h"

namespace snell {

// Replaces the file as a whole, so that a reader never sees an incomplete one. `answered` is the last question, see
// App.
void write_window_state(const std::string& file, const std::string& answered, const WindowCounters& counters,
                        Workspace& workspace, const View& view, const ui::Layout& layout, const ui::Memory& memory,
                        const ui::Facts& measured, PixelSize size);

}  // namespace snell
