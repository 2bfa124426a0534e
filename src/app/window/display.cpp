#include "src/app/window/display.h"

#include <algorithm>
#include <cmath>
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

std::vector<double> values_of(const Controls& controls) {
    std::vector<double> values;
    for (const Control& control : controls.items)
        values.insert(values.end(), control.value.begin(), control.value.end());
    return values;
}

void set_values(Controls& controls, const std::vector<double>& values) {
    auto next = values.begin();
    for (Control& control : controls.items)
        for (double& value : control.value)
            if (next != values.end()) value = *next++;
}

// Time alone moves nothing: an animated scene is sharp unless the user drags something.
bool Display::moved(const Drawn& next) const {
    const Stand &a = next.stand, &b = drawn_.stand;
    return a.width != b.width || a.height != b.height || a.view != b.view || a.values != b.values;
}

bool Display::prepare(Drawn next, Document& document, const Wanted& wanted) {
    next_ = std::move(next);
    if (wanted.sharp || next_.revision != drawn_.revision || next_.rungs != drawn_.rungs ||
        next_.showing != drawn_.showing)
        coarseness_ = {};
    if (std::exchange(held_, wanted.held) && !wanted.held) coarseness_.released();
    next_.grain = wanted.sharp ? 0 : coarseness_.next(moved(next_), wanted.held, window_.now());
    if (wanted.again || next_ != drawn_ || !document.runtime->settled()) {
        const PixelSize size = coarse_size(next_);
        return canvases_.of(next_).resize(size.width, size.height, grain_of(next_).samples,
                                          document.runtime->display_pixels());
    }
    document.runtime->skip_frame();
    return false;
}

void Display::draw_into(gl::Canvas& canvas, const Drawn& drawn, Document& document,
                        const std::function<void(const Step&)>* after, float density) {
    const Stand& stand = drawn.stand;
    const int divide = grain_of(drawn).divide;
    const PixelSize size = coarse_size(drawn);
    View view = stand.view;
    view.mouse_x /= divide;
    view.mouse_y /= divide;
    Frame frame{stand.time, view, document.controls, true};
    frame.after = after;
    frame.enlarged = divide;
    const Surface surface{canvas.framebuffer(), size.width, size.height};
    document.runtime->draw(frame, surface);
    if (drawn.object != none) document.runtime->outline(frame, surface, drawn.object, std::ceil(2 * density / divide));
    canvas.resolve();
    gl::finish();
}

void Display::draw(Document& document, const std::function<void(const Step&)>* after, float density) {
    const double start = window_.now();
    draw_into(canvases_.of(next_), next_, document, after, density);
    lost_ = loss_.lost();
    if (lost_) return;
    last_picture_ = start;
    counters_.frame_ms = (window_.now() - start) * 1e3;
    counters_.time = next_.stand.time;
    counters_.grain = next_.grain;
    ++counters_.frames;
    coarseness_.drew(counters_.frame_ms);
    drawn_ = std::move(next_);
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
