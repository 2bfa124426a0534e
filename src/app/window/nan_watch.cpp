#include "src/app/window/nan_watch.h"

#include <fmt/format.h>

#include <chrono>
#include <numeric>
#include <utility>

namespace snell {

void NanWatch::follow(const Drawn& shown, double now) {
    if (shown_ == shown) return;
    if (shown_.revision != shown.revision) slow_ = 0;
    shown_ = shown;
    since_ = now;
    looked_ = slow_ > 1;  // the first one may compile
    columns_.clear();
}

void NanWatch::look(std::span<Document* const> shown, const Stand& stand, double milliseconds) {
    using Clock = std::chrono::steady_clock;
    constexpr double most = 25;  // milliseconds, as far as the sharp picture tells
    int divide = 4;
    while (divide < 16 && milliseconds / divide / divide > most) divide *= 2;
    const Stand small = smaller(stand, divide);
    const Clock::time_point start = Clock::now();
    FloatPicture picture;
    if (!picture.resize(small.width, small.height)) shown = {};
    std::vector<float> rgba;
    for (Document* const document : shown) {
        columns_.emplace_back();
        if (!document) continue;
        View view;
        picture.draw(*document->runtime, drawn_again(*document, small, view), rgba);
        columns_.back() = count_flags(rgba, small.width);
    }
    width_ = small.width;
    ++looks_;
    looked_ = true;
    const double took = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    slow_ = took > Coarseness::patience && took > milliseconds / 4 ? slow_ + 1 : 0;
}

bool NanWatch::tell(std::optional<int> divider, bool hidden) {
    FlagCounts seen;
    for (std::size_t i = 0; i < columns_.size() && !hidden; ++i)
        for (int x = 0; x < static_cast<int>(columns_[i].size()); ++x) {
            if (divider && columns_.size() > 1 && (x < *divider) != (i == 0)) continue;
            seen += columns_[i][static_cast<std::size_t>(x)];
        }
    const auto pixels = static_cast<double>(std::accumulate(seen.pixels.begin(), seen.pixels.end(), std::size_t{0}));
    std::string text;
    for (const Flag flag : {Flag::nan, Flag::infinite}) {
        if (seen[flag] == 0) continue;
        const double percent = 100 * static_cast<double>(seen[flag]) / pixels;
        text += fmt::format("{}{} in {} %", text.empty() ? "" : ", ", name(flag),
                            percent < 1 ? "under 1" : fmt::format("{:.0f}", percent));
    }
    if (!text.empty()) text += ": N shows it";
    return std::exchange(text_, text) != text;
}

}  // namespace snell
