#include "src/app/picture/non_finite.h"

#include "src/runtime/flags.h"
#include "src/runtime/inspect.h"

namespace snell::app {

std::optional<NonFinite> count_non_finite(Runtime& runtime, const Frame& frame, int width, int height) {
    FloatPicture picture;
    if (!picture.resize(width, height)) return std::nullopt;
    std::vector<float> rgba;
    picture.draw(runtime, frame, rgba);
    const FlagCounts counts = count_flags(rgba);
    return NonFinite{counts[Flag::nan], counts[Flag::infinite]};
}

}  // namespace snell::app
