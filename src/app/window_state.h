// What a window is doing, as JSON, so that tests can look into it.
#pragma once

#include <cstdint>
#include <string>

#include "src/app/session.h"
#include "src/platform/window.h"
#include "src/ui/layout.h"
#include "src/ui/state.h"

namespace snell {

struct WindowCounters {
    std::uint64_t frames = 0;    // pictures of the scene drawn
    std::uint64_t presents = 0;  // times that the window's contents were replaced
    double time = 0;             // of the last picture
    double frame_ms = 0;
};

// The file is replaced as a whole: a reader never sees half of one.
void write_window_state(const std::string& file, const WindowCounters& counters, Session& session, const View& view,
                        const ui::Layout& layout, const ui::Memory& memory, const ui::Facts& measured, PixelSize size);

}  // namespace snell
