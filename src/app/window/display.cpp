#include "src/app/window/display.h"

#include <cmath>
#include <utility>

#include "src/ui/kit/style.h"

namespace snell {

namespace {

constexpr int samples_shown = 4;
constexpr double worth_compiling = 4;  // milliseconds of a frame

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

bool Display::prepare(Drawn next, Document& document, bool again) {
    next_ = std::move(next);
    if (again || next_ != drawn_ || !document.runtime->settled())
        return canvas_.resize(next_.stand.width, next_.stand.height, samples_shown, document.runtime->display_pixels());
    document.runtime->skip_frame();
    return false;
}

void Display::draw(Document& document, const std::function<void(const Step&)>* after, float density) {
    const double start = window_.now();
    const Stand& stand = next_.stand;
    Frame frame{stand.time, stand.view, document.controls, true};
    frame.after = after;
    const Surface surface{canvas_.framebuffer(), stand.width, stand.height};
    document.runtime->draw(frame, surface);
    if (next_.object != none) document.runtime->outline(frame, surface, next_.object, std::ceil(2 * density));
    canvas_.resolve();
    gl::finish();
    lost_ = loss_.lost();
    if (lost_) return;
    last_picture_ = start;
    counters_.frame_ms = (window_.now() - start) * 1e3;
    counters_.time = stand.time;
    ++counters_.frames;
    drawn_ = std::move(next_);
}

bool Display::specialise(Document& document) {
    const Stand& stand = drawn_.stand;
    if (counters_.frame_ms < worth_compiling || counters_.frames == 0) return false;
    const Frame frame{stand.time, stand.view, document.controls, true};
    return document.runtime->specialise(frame, {canvas_.framebuffer(), stand.width, stand.height});
}

void Display::show(PixelSize pixels) const {
    const ImVec4 around = ui::palette().surround;
    gl::clear_window(pixels.width, pixels.height, around.x, around.y, around.z);
    canvas_.show(0, bottom(pixels));
}

void Display::present() {
    window_.present();
    ++counters_.presents;
}

}  // namespace snell
