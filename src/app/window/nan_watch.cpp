#include "src/app/window/nan_watch.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>

#include "src/app/picture/non_finite.h"

namespace snell {

bool NanWatch::follow(const Drawn& shown, double now) {
    if (shown_ == shown) return false;
    if (shown_.revision != shown.revision) slow_ = 0;
    shown_ = shown;
    since_ = now;
    looked_ = slow_ > 1;  // the first one may compile
    return !std::exchange(text_, {}).empty();
}

bool NanWatch::look(std::span<Document* const> shown, const Stand& stand, double milliseconds) {
    using Clock = std::chrono::steady_clock;
    constexpr double most = 25;  // milliseconds, as far as the sharp picture tells
    int divide = 4;
    while (divide < 16 && milliseconds / divide / divide > most) divide *= 2;
    const Stand small = smaller(stand, divide);
    const Clock::time_point start = Clock::now();
    std::size_t nan = 0;
    for (Document* const document : shown) {
        View view;
        const Frame frame = drawn_again(*document, small, view);
        if (const auto found = app::count_non_finite(*document->runtime, frame, small.width, small.height))
            nan += found->nan;
    }
    ++looks_;
    looked_ = true;
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    slow_ = took > Coarseness::patience && took > milliseconds / 4 ? slow_ + 1 : 0;
    if (nan == 0) return false;
    const double pixels = static_cast<double>(shown.size()) * small.width * small.height;
    const double percent = 100 * static_cast<double>(nan) / pixels;
    text_ = fmt::format("NaN in {} %{}: N shows it", percent < 1 ? "under 1" : fmt::format("{:.0f}", percent),
                        shown.size() > 1 ? " of both sides" : "");
    return true;
}

}  // namespace snell
