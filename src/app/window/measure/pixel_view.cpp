#include "src/app/window/measure/pixel_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/plan/locate.h"

namespace snell {

// The off-screen targets still have what the window's picture drew, so they are not drawn again.
Frame PixelView::frame(const Document& shown, const Stand& stand) {
    view_ = stand.view;
    view_.axes = false;
    Frame frame{.time = stand.time, .view = view_, .controls = shown.controls, .paced = true};
    frame.standing = true;
    return frame;
}

bool PixelView::follow(Document& shown, const Stand& stand, std::uint64_t picture, const ui::PixelMemory& memory,
                       float density, std::string_view half) {
    const bool wanted = (memory.inspecting || memory.flags) && stand.width > 0 && stand.height > 0;
    if (!wanted) {
        const bool had = pixels_ != nullptr;
        if (had) *this = {};
        return had;
    }
    if (!pixels_) pixels_ = std::make_unique<FloatPicture>();
    if (!pixels_->resize(stand.width, stand.height)) {
        facts_.note = "The graphics driver has no pictures of floats.";
        return false;
    }
    bool fresh = false;
    if (!memory.inspecting) {
        fresh = facts_.inspection != nullptr;
        facts_.inspection = nullptr;
        looked_ = 0;
    } else {
        const int x = std::clamp(static_cast<int>(std::floor(memory.x * density)), 0, stand.width - 1);
        const int y = std::clamp(static_cast<int>(std::floor(memory.y * density)), 0, stand.height - 1);
        if (looked_ != picture || found_.x != x || found_.y != y || half_ != half) {
            half_ = half;
            look(shown, stand, x, y);
            looked_ = picture;
            fresh = true;
        }
    }
    if (!memory.flags) {
        fresh |= facts_.flags.has_value();
        facts_.flags.reset();
        still_ = {};
        flagged_ = 0;
    } else if (flagged_ != picture) {
        flag(shown, stand);
        flagged_ = picture;
        fresh = true;
    }
    return fresh;
}

void PixelView::look(Document& shown, const Stand& stand, int x, int y) {
    pixels_->inspect(*shown.runtime, frame(shown, stand), x, y, radius, found_);
    facts_.inspection = &found_;
    facts_.at = fmt::format("pixel {}, {}", found_.x, found_.y);
    facts_.half = half_;
    facts_.statement.clear();
    facts_.place.clear();
    if (found_.draw >= shown.scene().draws.size()) return;
    const Span& span = shown.scene().draws[found_.draw].span;
    facts_.statement = statement_text(span, shown.sources);
    facts_.place = statement_place(span, shown.sources);
}

void PixelView::flag(Document& shown, const Stand& stand) {
    pixels_->draw(*shown.runtime, frame(shown, stand), rgba_);
    facts_.flags = count_flags(rgba_);
    paint_flags(rgba_, painted_);
    still_.set(stand.width, stand.height, painted_);
}

void PixelView::show(int y) const {
    if (facts_.flags) still_.show(0, y, 0);
}

}  // namespace snell
