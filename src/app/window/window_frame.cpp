// The picture of the scene, and what the window shows of it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "src/app/window/app.h"
#include "src/ui/shell.h"

namespace snell {

namespace {

constexpr int samples_shown = 4;

}  // namespace

void gather(const Controls& controls, std::vector<double>& values) {
    values.clear();
    for (const Control& control : controls.items)
        values.insert(values.end(), control.value.begin(), control.value.end());
}

void App::show(bool repaint) {
    const PixelSize pixels = window_->framebuffer();
    remember_size();
    const bool drew = draw_scene(pixels);
    if (lost_) return;
    if (Document* document = session_.document())
        accuracy_.follow(*document, session_.stale(), drawn_.stand, memory_.accuracy);
    const bool told = look_at_pixels();
    const std::uint64_t beside = accuracy_.revision(memory_.accuracy);
    if (drew || told || repaint || interface_ != presented_ || beside != presented_beside_) {
        present(pixels);
        presented_ = interface_;
        presented_beside_ = beside;
        ++counters_.presents;
    }
    if (options_.state_file.empty()) return;
    ui::Facts measured;
    tell_measured(measured);
    write_window_state(options_.state_file, counters_, session_, view_, layout_, memory_, measured, pixels);
}

bool App::look_at_pixels() {
    Document* document = session_.document();
    const Stand& stand = drawn_.stand;
    if (!document || memory_.scene.width <= 0) return false;
    const float density = static_cast<float>(stand.width) / memory_.scene.width;
    if (!pixels_.follow(*document, stand, counters_.frames, memory_.pixels, density)) return false;
    unsettled_ = std::max(unsettled_, 1);  // the panels tell of it
    return true;
}

void App::remember_size() {
    if (options_.size || own_size()) return;
    const PixelSize size = window_->size();
    const double scale = window_->content_scale();
    opener_.resized(static_cast<int>(std::lround(size.width / scale)),
                    static_cast<int>(std::lround(size.height / scale)));
}

bool App::draw_scene(PixelSize pixels) {
    Document* document = session_.document();
    if (!document) return false;
    const float density = static_cast<float>(pixels.width) / static_cast<float>(std::max(1, window_->size().width));
    next_.revision = session_.stale() ? drawn_.revision : session_.revision();
    Stand& stand = next_.stand;
    stand.width = std::max(1, static_cast<int>(std::lround(memory_.scene.width * density)));
    stand.height = std::max(1, static_cast<int>(std::lround(memory_.scene.height * density)));
    const double time = scene_time();
    stand.time = document->runtime->animated() ? time : 0;
    stand.view = view_;
    gather(document->controls, stand.values);
    next_.rungs = document->controls.rungs;
    next_.object = memory_.hold.object;
    if (next_ == drawn_ && document->runtime->settled()) {
        document->runtime->skip_frame();
        return false;
    }
    if (!canvas_.resize(stand.width, stand.height, samples_shown, document->runtime->display_pixels())) return false;
    const double start = window_->now();
    frame_costs_.open(memory_.frame_cost);
    Frame frame{stand.time, view_, document->controls, true};
    frame.after = frame_costs_.begin(next_.revision);
    const Surface surface{canvas_.framebuffer(), stand.width, stand.height};
    hang_.begin("drawing a frame");
    document->runtime->draw(frame, surface);
    if (next_.object != none) document->runtime->outline(frame, surface, next_.object, std::ceil(2 * density));
    canvas_.resolve();
    gl::finish();
    hang_.rest();
    lost_ = loss_.lost();
    if (lost_) return false;
    session_.drawn_well();
    frame_costs_.end();
    last_picture_ = start;
    counters_.frame_ms = (window_->now() - start) * 1e3;
    counters_.time = stand.time;
    ++counters_.frames;
    std::swap(drawn_, next_);
    unsettled_ = std::max(unsettled_, 1);  // the panels show what it cost
    return true;
}

void App::present(PixelSize pixels) {
    const ImVec4 around = ui::palette().surround;
    gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
    if (session_.document()) {
        canvas_.show(0, pixels.height - drawn_.stand.height);
        accuracy_.show(pixels.height - drawn_.stand.height, memory_.accuracy);
        pixels_.show(pixels.height - drawn_.stand.height);
    }
    painter_.paint();
    window_->present();
}

}  // namespace snell
