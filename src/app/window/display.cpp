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
constexpr double short_strip = 100;    // milliseconds, below which the next one is higher
constexpr double long_strip = 400;     // above which it is lower

const Grain& grain_of(const Drawn& drawn) { return grains[static_cast<std::size_t>(drawn.grain)]; }

PixelSize coarse_size(const Drawn& drawn) {
    const Grain& grain = grain_of(drawn);
    return {grain.part_of(drawn.stand.width), grain.part_of(drawn.stand.height)};
}

}  // namespace

// Time alone moves nothing: an animated scene is sharp unless the user drags something.
bool Display::moved(const Drawn& next) const {
    const Stand &a = next.stand, &b = drawn_.stand;
    return a.width != b.width || a.height != b.height || a.view != b.view || a.values != b.values;
}

double Display::sharp_due() const {
    if (strips_) return 0;
    return runs_ ? std::numeric_limits<double>::infinity() : coarseness_.due();
}

bool Display::prepare(Drawn next, Document& document, const Wanted& wanted) {
    next_ = std::move(next);
    const bool other =
        next_.revision != drawn_.revision || next_.rungs != drawn_.rungs || next_.showing != drawn_.showing;
    const bool moves = moved(next_);
    // What moves by itself is sharp, unless nobody would see that it moves.
    const bool runs = wanted.runs ? moves : !moves && next_.stand.time != drawn_.stand.time;
    runs_ = runs && coarseness_.lasts();
    const bool may_be_coarse = runs ? runs_ : moves;
    if (wanted.sharp || other || (wanted.runs && runs && !may_be_coarse)) coarseness_ = {};
    if (std::exchange(held_, wanted.held) && !wanted.held) coarseness_.released();
    next_.grain = wanted.sharp ? 0 : coarseness_.next(may_be_coarse, wanted.held || runs, window_.now());
    const bool may_last = !wanted.sharp && next_.grain == 0 && document.runtime->long_loops(document.controls) > 0;
    ahead_ = may_last && (other || moves || may_be_coarse);
    const bool strips = may_last && !ahead_ && next_ != drawn_ && !wanted.again && coarseness_.lasts();
    if (!strips)
        strips_.reset();
    else if (!strips_ || strips_->of != next_)
        strips_ = {next_, 0, first_strip()};
    if (wanted.again || next_ != drawn_ || !document.runtime->settled()) {
        const PixelSize size = coarse_size(next_);
        return canvases_.of(next_).resize(size.width, size.height, grain_of(next_).samples,
                                          document.runtime->display_pixels());
    }
    document.runtime->skip_frame();
    return false;
}

void Display::draw_into(gl::Canvas& canvas, const Drawn& drawn, Document& document,
                        const std::function<void(const Step&)>* after, float density,
                        const std::optional<PixelRect>& part) {
    const Stand& stand = drawn.stand;
    const int divide = grain_of(drawn).divide;
    const PixelSize size = coarse_size(drawn);
    View view = stand.view;
    view.mouse_x /= divide;
    view.mouse_y /= divide;
    Frame frame{stand.time, view, document.controls, !part};
    frame.after = after;
    frame.enlarged = divide;
    frame.standing = part && part->bottom > 0;
    const Surface surface{canvas.framebuffer(), size.width, size.height, part};
    document.runtime->draw(frame, surface);
    if (part && part->bottom + part->height < size.height) return gl::finish();
    if (drawn.object != none)
        document.runtime->outline(frame, {canvas.framebuffer(), size.width, size.height}, drawn.object,
                                  std::ceil(2 * density / divide));
    canvas.resolve();
    gl::finish();
}

bool Display::draw_ahead(Document& document, float density) {
    Drawn coarse = next_;
    coarse.grain = coarsest;
    const PixelSize size = coarse_size(coarse);
    if (!canvases_.coarse.resize(size.width, size.height, grain_of(coarse).samples, document.runtime->display_pixels()))
        return false;
    const double start = window_.now();
    draw_into(canvases_.coarse, coarse, document, nullptr, density);
    const double end = window_.now();
    if (!coarseness_.foresaw((end - start) * 1e3, end)) return false;
    next_.grain = coarsest;
    return true;
}

// What takes about as long as anyone waits, and at most as many pixels as the coarsest grain has.
int Display::first_strip() const {
    const int height = next_.stand.height, most = grains.back().part_of(grains.back().part_of(height));
    return std::clamp(static_cast<int>(height * Coarseness::patience / coarseness_.foreseen()), 1, most);
}

double Display::sharp_share() const {
    return strips_ ? static_cast<double>(strips_->rows) / strips_->of.stand.height : 0;
}

bool Display::draw_strip(Document& document, float density) {
    Strips& strips = *strips_;
    const int height = next_.stand.height, rows = std::min(strips.next, height - strips.rows);
    const double start = window_.now();
    draw_into(canvases_.sharp, next_, document, nullptr, density, PixelRect{0, strips.rows, next_.stand.width, rows});
    const double ms = (window_.now() - start) * 1e3;
    strips.ms += ms;
    strips.rows += rows;
    ++counters_.strips;
    if (ms < short_strip) strips.next *= 2;
    if (ms > long_strip) strips.next = std::max(strips.next / 2, 1);
    return strips.rows >= height;
}

bool Display::draw(Document& document, const std::function<void(const Step&)>* after, float density) {
    double start = window_.now();
    const bool ahead = ahead_ && !after && draw_ahead(document, density);
    if (ahead_ && !ahead) start = window_.now();
    const bool strip = strips_ && !after, whole = !strip || draw_strip(document, density);
    if (!ahead && !strip) draw_into(canvases_.of(next_), next_, document, after, density);
    lost_ = loss_.lost();
    if (lost_ || !whole) return false;
    last_picture_ = start;
    counters_.frame_ms = strip ? strips_->ms : (window_.now() - start) * 1e3;
    strips_.reset();
    counters_.time = next_.stand.time;
    counters_.grain = next_.grain;
    ++counters_.frames;
    if (next_.grain > 0) ++counters_.coarse;
    if (!ahead) coarseness_.drew(counters_.frame_ms);
    drawn_ = std::move(next_);
    return true;
}

bool Display::draw_beside(Drawn next, Document& document, float density) {
    next.grain = drawn_.grain;
    if (next == drawn_beside_ && document.runtime->settled()) return false;
    const PixelSize size = coarse_size(next);
    gl::Canvas& canvas = beside_.of(next);
    if (!canvas.resize(size.width, size.height, grain_of(next).samples, document.runtime->display_pixels()))
        return false;
    const double start = window_.now();
    draw_into(canvas, next, document, nullptr, density);
    lost_ = loss_.lost();
    if (lost_) return false;
    coarseness_.drew_beside((window_.now() - start) * 1e3);
    drawn_beside_ = std::move(next);
    return true;
}

content::Image Display::thumbnail() const {
    if (counters_.frames == 0 || lost_) return {};
    const PixelSize size = coarse_size(drawn_);
    content::Image picture{.width = size.width, .height = size.height};
    picture.pixels = canvases_.of(drawn_).read();
    return picture.pixels.size() == picture.bytes() ? app::thumbnail(picture) : content::Image{};
}

bool Display::specialise(Document& document) {
    const Stand& stand = drawn_.stand;
    if (counters_.frame_ms < worth_compiling || counters_.frames == 0 || drawn_.grain > 0) return false;
    const Frame frame{stand.time, stand.view, document.controls, true};
    return document.runtime->specialise(frame, {canvases_.sharp.framebuffer(), stand.width, stand.height});
}

void Display::show(PixelSize pixels, std::optional<int> divider) const {
    const ImVec4 around = ui::palette().surround;
    gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
    canvases_.of(drawn_).show(0, bottom(pixels), drawn_.stand.width, drawn_.stand.height);
    if (divider && drawn_beside_.stand.width > 0)
        beside_.of(drawn_beside_)
            .show(0, bottom(pixels), drawn_beside_.stand.width, drawn_beside_.stand.height, 0, std::max(1, *divider));
}

void Display::present(double interface_ms) {
    const double start = window_.now();
    window_.present();
    counters_.present_ms = (window_.now() - start) * 1e3;
    counters_.interface_ms = interface_ms;
    ++counters_.presents;
}

}  // namespace snell
