// Writes the state of a window as JSON, for tests.
#pragma once

#include <cstdint>
#include <string>

#include "src/app/window/session.h"
#include "src/platform/window.h"
#include "src/ui/kit/layout.h"
#include "src/ui/panels/state.h"

namespace snell {

struct WindowCounters {
    std::uint64_t frames = 0;    // number of pictures of the scene that were drawn
    std::uint64_t presents = 0;  // number of times that the window's contents were replaced
    double time = 0;             // of the last picture, in seconds
    double frame_ms = 0;
};

// Replaces the file as a whole, so that a reader never sees an incomplete one.
void write_window_state(const std::string& file, const WindowCounters& counters, Session& session, const View& view,
                        const ui::Layout& layout, const ui::Memory& memory, const ui::Facts& measured, PixelSize size);

}  // namespace snell
