#include "src/app/non_finite.h"

#include <cmath>

#include "src/gl/target.h"

namespace snell::app {

std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height) {
    const gl::Target target = gl::make_target(width, height, 1, gl::Pixels::rgba32f);
    if (!target.framebuffer) return std::nullopt;
    runtime.draw(frame, {target.framebuffer.get(), width, height});
    NonFinite found;
    const auto values = gl::read_rgba32f(target.framebuffer.get(), width, height, 1);
    for (std::size_t pixel = 0; pixel + 3 < values.size(); pixel += 4) {
        bool nan = false, infinite = false;
        for (std::size_t c = 0; c < 4; ++c) {
            nan = nan || std::isnan(values[pixel + c]);
            infinite = infinite || std::isinf(values[pixel + c]);
        }
        found.nan += nan;
        found.infinite += infinite && !nan;
    }
    return found;
}

}  // namespace snell::app
