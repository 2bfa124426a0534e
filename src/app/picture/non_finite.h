// Counts pixels with NaN or infinite values, which a picture of bytes shows as 0 or 255, depending on the driver.
#pragma once

#include <cstddef>
#include <optional>

#include "src/document/document.h"

namespace snell::app {

struct NonFinite {
    std::size_t nan = 0;       // pixels with a channel that is NaN
    std::size_t infinite = 0;  // pixels with an infinite channel and none that is NaN
};

// Draws the frame again into floats and counts before values are clamped, except in off-screen targets, which hold
// bytes. Returns nullopt if the context has no float target.
std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height);

// Whether a shader divides, or calls a function that is not defined for every number.
bool may_give_nan(const Plan& plan, const Sources& sources);
// Draws a small picture of a scene without errors, and adds a warning for each program that gives NaN in it.
void warn_of_nan(Document& document);

}  // namespace snell::app
