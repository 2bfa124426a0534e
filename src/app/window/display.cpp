#include "src/app/window/display.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "src/app/picture/sheet.h"
#include "src/ui/kit/style.h"

namespace snell {

namespace {

constexpr double worth_compiling = 4;  // milliseconds of a frame

const Grain& grain_of(const Drawn& drawn) { return grains[static_cast<std::size_t>(drawn.grain)]; }

PixelSize coarse_size(const Drawn& drawn) {
    const Grain& grain = grain_of(drawn);
    return {grain.part_of(drawn.stand.width), grain.part_of(drawn.stand.height)};
}

}  // namespace

bool Display::Side::other() const {
    const Drawn& next = half.next;
    return next.revision != drawn.revision || next.rungs != drawn.rungs || next.showing != drawn.showing;
}

// Time alone moves nothing: an animated scene is sharp unless the user drags something.
bool Display::Side::moved() const {
    const Stand &a = half.next.stand, &b = drawn.stand;
    return a.width != b.width || a.height != b.height || a.view != b.view || a.values != b.values;
}

double Display::sharp_due() const {
    if (sharp_) return 0;
    return runs_ ? std::numeric_limits<double>::infinity() : coarseness_.due();
}

double Display::lasts() const { return may_last_ && coarseness_.lasts(most()) ? coarseness_.foreseen() : 0; }

double Display::most() const { return loops_ ? std::numeric_limits<double>::infinity() : 4 * sharp_ms_; }

bool Display::any(const std::function<bool(const Side&)>& holds) const {
    return holds(sides_[0]) || (two_ && holds(sides_[1]));
}

void Display::set_grain(int grain) {
    for (Side& side : shown()) side.half.next.grain = grain;
}

bool Display::prepare(Half left, std::optional<Half> right, const Wanted& wanted) {
    const bool runs_on = left.next.stand.time != drawn().stand.time;
    sides_[0].half = std::move(left);
    two_ = right.has_value();
    sides_[1].half = std::move(right).value_or(Half{});
    if (std::array now{sides_[0].half.next, sides_[1].half.next}; next_ != now) {
        next_ = std::move(now);
        spent_ms_ = 0;
        given_up_ = false;
    }
    const bool other = any(&Side::other), moves = any(&Side::moved);
    // What moves by itself is sharp, unless nobody would see that it moves.
    const bool runs = wanted.runs ? moves : !moves && runs_on;
    runs_ = runs && coarseness_.lasts();
    const bool may_be_coarse = runs ? runs_ : moves;
    if (wanted.sharp || other || (wanted.runs && runs && !may_be_coarse)) coarseness_ = {};
    if (std::exchange(held_, wanted.held) && !wanted.held) coarseness_.released();
    const int next = wanted.sharp ? 0 : coarseness_.next(may_be_coarse, wanted.held || runs, window_.now());
    const int grain = given_up_ ? drawn().grain : next;
    set_grain(grain);
    loops_ = any([](const Side& s) { return s.half.document->runtime->long_loops(s.half.document->controls) > 0; });
    may_last_ = !wanted.sharp && (loops_ || sharp_ms_ > Coarseness::patience);
    const bool in_vain = may_last_ && coarseness_.lasts() && lasts() == 0;
    ahead_ = may_last_ && !in_vain && grain == 0 && (other || moves || may_be_coarse);
    const bool due = wanted.again || any([](const Side& side) {
                         return side.half.next != side.drawn || !side.half.document->runtime->settled();
                     });
    if (!due || ahead_ || grain > 0 || lasts() == 0) {
        sharp_.reset();
    } else if (std::array now{sides_[0].half.next, sides_[1].half.next}; !sharp_ || sharp_of_ != now) {
        sharp_.emplace(now[0].stand.width, now[0].stand.height, lasts());
        sharp_of_ = std::move(now);
        ms_ = 0;
    }
    if (due) return resize();
    for (const Side& side : shown()) side.half.document->runtime->skip_frame();
    return false;
}

bool Display::resize() {
    bool all = true;
    for (Side& side : shown()) {
        const PixelSize size = coarse_size(side.half.next);
        all = all && side.canvases.of(side.half.next)
                         .resize(size.width, size.height, grain_of(side.half.next).samples,
                                 side.half.document->runtime->display_pixels());
    }
    return all;
}

void Display::draw_all(const std::function<void(const Step&)>* after, float density,
                       const std::optional<PixelRect>& part) {
    const double start = window_.now();
    for (Side& side : shown()) {
        const auto& [drawn, document] = side.half;
        gl::Canvas& canvas = side.canvases.of(drawn);
        const int divide = grain_of(drawn).divide;
        const PixelSize size = coarse_size(drawn);
        View view = drawn.stand.view;
        view.mouse_x /= divide;
        view.mouse_y /= divide;
        Frame frame{drawn.stand.time, view, document->controls, !part};
        frame.after = std::exchange(after, nullptr);
        frame.enlarged = divide;
        // Something else may have been drawn since the last strip, such as a picture that is being saved.
        const bool first = !part || (part->bottom == 0 && part->left == 0);
        frame.standing = !first && document->runtime->counters().frames == side.frames;
        document->runtime->draw(frame, {canvas.framebuffer(), size.width, size.height, part});
        side.frames = document->runtime->counters().frames;
        const bool last =
            !part || (part->bottom + part->height == size.height && part->left + part->width == size.width);
        if (last && drawn.object != none)
            document->runtime->outline(frame, {canvas.framebuffer(), size.width, size.height}, drawn.object,
                                       std::ceil(2 * density / divide));
        if (last) canvas.resolve();
        gl::finish();
    }
    const double took = (window_.now() - start) * 1e3;
    ms_ += took;
    spent_ms_ += took;
}

bool Display::draw_ahead(float density) {
    const auto timed = [&](int grain) {
        ms_ = 0;
        set_grain(grain);
        if (resize()) draw_all(nullptr, density);
        return ms_;
    };
    if (coarseness_.foresee(timed, window_.now(), most())) return true;
    set_grain(0);
    return false;
}

bool Display::draw_strips(float density) {
    return sharp_->draw([&](const PixelRect& strip) {
        const double before = ms_;
        draw_all(nullptr, density, strip);
        ++counters_.strips;
        return ms_ - before;
    });
}

bool Display::draw(const std::function<void(const Step&)>* after, float density) {
    double start = window_.now();
    const bool once = at_once(), ahead = ahead_ && draw_ahead(density), whole = !sharp_ || draw_strips(density);
    if (!ahead && !sharp_) {
        start = window_.now();
        ms_ = 0;
        draw_all(once ? after : nullptr, density);
    }
    lost_ = loss_.lost();
    if (!whole && longest_ > 0 && spent() > longest_) {
        given_up_ = true;
        sharp_.reset();
    }
    if (lost_ || !whole) return false;
    last_picture_ = start;
    sharp_.reset();
    for (Side& side : shown()) side.drawn = std::move(side.half.next);
    counters_.frame_ms = ms_;
    counters_.time = drawn().stand.time;
    counters_.grain = drawn().grain;
    if (counters_.grain == 0) {
        sharp_ms_ = ms_;
        spent_ms_ = 0;
    }
    ++counters_.frames;
    if (counters_.grain > 0) ++counters_.coarse;
    if (!ahead) coarseness_.drew(ms_);
    return true;
}

content::Image Display::thumbnail() const {
    if (counters_.frames == 0 || lost_) return {};
    const PixelSize size = coarse_size(drawn());
    content::Image picture{.width = size.width, .height = size.height};
    picture.pixels = sides_[0].canvases.of(drawn()).read();
    return picture.pixels.size() == picture.bytes() ? app::thumbnail(picture) : content::Image{};
}

bool Display::specialise(Document& document) {
    const Stand& stand = drawn().stand;
    if (counters_.frame_ms < worth_compiling || counters_.frames == 0 || drawn().grain > 0) return false;
    const Frame frame{stand.time, stand.view, document.controls, true};
    return document.runtime->specialise(frame, {sides_[0].canvases.sharp.framebuffer(), stand.width, stand.height});
}

void Display::show(PixelSize pixels, std::optional<int> divider) const {
    const ImVec4 around = ui::palette().surround;
    gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
    const auto copy = [&](const Side& side, int first) {
        const Stand& stand = side.drawn.stand;
        side.canvases.of(side.drawn).show(0, bottom(pixels), stand.width, stand.height, 0, first);
    };
    copy(sides_[0], 0);
    if (divider && sides_[1].drawn.stand.width > 0) copy(sides_[1], *divider);
}

void Display::present(double interface_ms) {
    const double start = window_.now();
    window_.present();
    counters_.present_ms = (window_.now() - start) * 1e3;
    counters_.interface_ms = interface_ms;
    ++counters_.presents;
}

}  // namespace snell
