// Pixels that are no numbers: a picture of bytes shows them as 0 or 255, by the driver's choice.
#pragma once

#include <cstddef>
#include <optional>

#include "src/runtime/runtime.h"

namespace snell::app {

struct NonFinite {
    std::size_t nan = 0;       // pixels with a channel that is NaN
    std::size_t infinite = 0;  // pixels with an infinite channel, and none that is NaN
};

// Draws the frame once more, into floats, and counts before anything is clamped: off-screen targets excepted, which
// hold bytes. Nothing where the context has no such target.
std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height);

}  // namespace snell::app
