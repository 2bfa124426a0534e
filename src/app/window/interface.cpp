#include "src/app/window/interface.h"

#include <utility>

#include "src/app/desktop/settings.h"
#include "src/ui/shell.h"
#include "src/ui/status.h"

namespace snell {

Interface::Interface(Window& window, bool listening) : window_(window), gui_(&window), layout_(listening) {
    view_.axes = true;  // for a window that loses its context before a scene could be read
}

void Interface::begin_scene() {
    ui::Memory fresh;
    carry_looks(memory_, fresh);
    memory_ = std::move(fresh);
    view_ = {};
}

void Interface::start() { framed_ = ticked_ = window_.now(); }

float Interface::density() const {
    const int width = window_.size().width;
    return width > 0 ? static_cast<float>(window_.framebuffer().width) / static_cast<float>(width) : 1.0F;
}

void Interface::begin(double seconds, std::span<const Event> events) {
    const PixelSize size = window_.size();
    const ui::Screen screen{static_cast<float>(size.width), static_cast<float>(size.height), density(),
                            window_.content_scale() / density() * memory_.zoom, memory_.theme};
    if (gui_.input(screen, seconds, events)) painter_.upload_fonts();
    gui_.begin();
}

ui::Requests Interface::frame(std::span<const Event> events, const ui::Facts& facts, Controls& controls) {
    const double now = window_.now();
    begin(now - std::exchange(framed_, now), events);
    ui::Requests requests = ui::shell(facts, controls, view_, memory_, gui_.fonts(), layout_);
    picture_ = gui_.end();
    window_.set_cursor(gui_.cursor());
    for (const Event& event : events)
        if (event.down && event.kind != Event::Kind::focus) memory_.notice.clear();
    return requests;
}

void Interface::loading(const LoadProgress& progress) {
    begin(0, {});
    ui::loading(words(progress), share(progress));
    gui_.end();
}

double Interface::time(bool stopped) {
    const double now = window_.now();
    ui::Clock& clock = memory_.clock;
    if (!held() && !clock.paused && !stopped) clock.time += (now - ticked_) * clock.speed;
    ticked_ = now;
    return clock.time;
}

}  // namespace snell
